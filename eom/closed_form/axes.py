"""From the SAE axes of the hand-derived models to the ISO 8855 axes of everything else, and back.

Both have x forward. SAE has y right and z down, ISO 8855 has y left and z up: a half turn about x. What lies along x,
or turns about it, keeps its sign; what lies along y or z, or turns about them, changes it.
"""

from collections.abc import Sequence

import numpy as np

from eom.closed_form.arrays import Array
from eom.closed_form.state_space import StateSpace
from eom.errors import EomError

KEPT = ("U", "F_x", "phi", "phi_dot", "phi_t", "phi_t_dot", "M_x")
CHANGED = (
    *("Y", "v", "a_y", "a_y_cg", "F_y", "beta", "delta"),
    *("psi", "psi_dot", "Delta_psi", "Delta_psi_dot", "M_z"),
)
SIGNS = dict.fromkeys(KEPT, 1.0) | dict.fromkeys(CHANGED, -1.0)
"""Sign that a quantity takes when its axes change, in either direction."""


def signs(names: Sequence[str]) -> Array:
    """Sign of each named quantity, (names,): +1 where SAE and ISO 8855 agree, -1 where they do not.

    Names are the thesis's symbols, with or without the number of a unit or axle: ``beta_1``, ``M_x_1f``.

    Raises
    ------
    EomError
        With every name that is none of those.
    """
    found = [SIGNS.get(name, SIGNS.get(name.rpartition("_")[0])) for name in names]
    unknown = [name for name, sign in zip(names, found, strict=True) if sign is None]
    if unknown:
        raise EomError(f"axes: expected names made of {', '.join(SIGNS)}; got {', '.join(unknown)}")
    return np.array(found, dtype=float)


def other_axes(model: StateSpace) -> StateSpace:
    """A hand-derived model in ISO 8855 axes, or one of those back in SAE axes.

    The half turn is its own inverse. Symbols stay the same; their meaning turns with the axes.

    Raises
    ------
    EomError
        If a state, input or output has a name whose sign is not known.
    """
    x, u, y = (signs(names) for names in (model.states, model.inputs, model.outputs))
    return StateSpace(
        A=x[:, np.newaxis] * model.A * x,
        B=x[:, np.newaxis] * model.B * u,
        C=y[:, np.newaxis] * model.C * x,
        D=y[:, np.newaxis] * model.D * u,
        states=model.states,
        inputs=model.inputs,
        outputs=model.outputs,
    )
