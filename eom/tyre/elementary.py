"""Elementary functions of the tyre formulas, for real numbers, and complex ones that carry a derivative.

In compiled programs they are those of `eom.program.elementary`.
"""

from typing import Any

import numpy as np

from eom.tyre.parameters import Values

arctan = np.arctan
cos = np.cos
exp = np.exp
log = np.log
maximum = np.maximum
minimum = np.minimum
sin = np.sin
sqrt = np.sqrt
tan = np.tan


def sense(x: Values) -> Any:
    """One with the sign of the real part of x; zero has the sign that it carries."""
    return np.copysign(1.0, np.real(x))


def magnitude(x: Values) -> Any:
    """Whichever of x and -x has a real part that is not negative."""
    return x * sense(x)
