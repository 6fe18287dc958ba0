"""What a run needs to know of each kind of model: program, limits, sizes of states, start."""

from typing import NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.model.linear import LinearModel
from eom.model.tyre import TyreModel
from eom.program.make import Ready
from eom.simulation.channels import STATE
from eom.splice.limits import Limit

Model = TyreModel | LinearModel

SIZES = {"m": 1.0, "rad": 0.1, "m/s": 1.0, "rad/s": 0.1, "N*m": 1e3}
"""Sizes of states that count as one where errors are measured, by unit."""


class Equations(NamedTuple):
    """What to integrate.

    Attributes
    ----------
    ready : Ready
        The program with its parameters.
    limits : tuple of Limit
    size, growing : Array
        Size of each state that counts as one, and 1 where its own value adds to it.
    """

    ready: Ready
    limits: tuple[Limit, ...]
    size: Array
    growing: Array


def check_kind(model: object) -> None:
    """Raise `SimulationError` for what is no model."""
    if not isinstance(model, TyreModel | LinearModel):
        raise SimulationError(f"{type(model).__name__} is no model: expected what eom.build or eom.linearise give")


def equations_of(model: Model) -> Equations:
    """The equations of a model."""
    growing = np.ones(len(model.states))
    # place and heading of the whole grow without meaning
    growing[list(model.cyclic) if isinstance(model, LinearModel) else [0, 1, 2]] = 0.0
    size = np.array([SIZES.get(unit, 1.0) for unit in model.state_units])
    return Equations(model.program, model.limits if isinstance(model, TyreModel) else (), size, growing)


def at_start(model: Model, speed: float | None) -> tuple[Array, Array]:
    """State and inputs from which a run starts: those of the straight run at a speed [m/s]; zero for linear models."""
    if isinstance(model, TyreModel):
        x, u = model.trim(speed)
        return x, u
    if speed is not None:
        raise SimulationError(f"speed = {speed:g} m/s: a linear model has that of its trim, {model.speed:g} m/s")
    return np.zeros(len(model.states)), np.zeros(len(model.inputs))


def every_name(model: Model) -> list[str]:
    """What can be kept, in the order of the columns: states, inputs, outputs."""
    return [*(STATE + name for name in model.states), *model.inputs, *model.outputs]
