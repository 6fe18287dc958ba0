"""Whether what is given is of the kind that is expected: a sentence for what is not."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np


def is_number(value: Any) -> bool:
    """Whether a value is one real number; truth is none."""
    if isinstance(value, np.ndarray):
        return value.ndim == 0 and value.dtype.kind in "fiu"
    return isinstance(value, (float, int, np.floating, np.integer)) and not isinstance(value, bool)


def are_numbers(values: Any) -> bool:
    """Whether values are a row of real numbers."""
    try:
        row = np.asarray(values)
    except (TypeError, ValueError):
        return False
    return row.ndim == 1 and (row.dtype.kind in "fiu" or not row.size)


def number_kinds(values: Mapping[str, Any], optional: Mapping[str, Any]) -> Iterator[str]:
    """Sentences for values, by name, that are no numbers; *optional* ones may be None."""
    for name, value in {**values, **{name: value for name, value in optional.items() if value is not None}}.items():
        if not is_number(value):
            yield f"{name} = {value!r}: expected a number"


def mapping_kinds(values: Mapping[str, Any]) -> Iterator[str]:
    """Sentences for values, by name, that are no mappings with names as keys."""
    for name, value in values.items():
        if not isinstance(value, Mapping):
            yield f"{name}: expected a mapping by name, got {kind(value)}"
        else:
            for key in value:
                if not isinstance(key, str):
                    yield f"{name}: {key!r} is no name"


def list_kinds(name: str, values: Any, of: str) -> Iterator[str]:
    """Sentences for what is no list of some kind."""
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, (Sequence, np.ndarray)):
        yield f"{name}: expected a list of {of}, got {kind(values)}"


def kind(value: Any) -> str:
    """What a value is, in words."""
    return "None" if value is None else f"{value!r}" if isinstance(value, str) else f"a {type(value).__name__}"
