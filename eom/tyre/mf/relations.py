"""What numbers of a Magic Formula tyre say together and cannot."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from eom.tyre.mf.ranges import range_problems


def relation_problems(owner: Any, values: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """For every number that others forbid: its name, and the sentence.

    *values* are numbers of *owner*, a parameter object or its class; those left out have their default.
    """
    yield from range_problems(owner, values)
    greatest, load = np.asarray(values.get("PTY1", 0.0)), np.asarray(values.get("PTY2", 1.0))
    if np.any((greatest != 0.0) & (load == 0.0)):
        yield "PTY2", f"expected a number other than 0, as PTY1 = {greatest} is the relaxation length at that load"
