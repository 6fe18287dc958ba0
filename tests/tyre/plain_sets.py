"""Sets with few coefficients: a published one, and 6.1 sets that are 5.2 sets."""

from collections.abc import Mapping

from tests.tyre.random_sets import NAMES_61, SCALES_61
from tests.tyre.referee_mf52 import stiffnesses_52
from tests.tyre.referee_mf_forces import camber_stiffness, tool_point

BOOK_DEFAULTS = {
    "UNLOADED_RADIUS": 0.3135,
    "FNOMIN": 4000.0,
    "LONGVL": 16.7,
    "NOMPRES": 2.2e5,
    "INFLPRES": 2.2e5,
    "LONGITUDINAL_STIFFNESS": 4e5,
    "LATERAL_STIFFNESS": 1e5,
    "PCFX3": 0.2,
    "PCFY3": 0.5,
    "PCX1": 1.6,
    "PDX1": 1.0,
    "PDX2": -0.1,
    "PKX1": 16.0,
    "RBX1": 8.3,
    "RBX2": 5.0,
    "RCX1": 0.9,
    "PCY1": 1.3,
    "PDY1": 1.0,
    "PDY2": -0.05,
    "PKY1": -15.0,
    "PKY2": 2.0,
    "PKY4": 2.0,
    "PKY6": -1.0,
    "RBY1": 4.9,
    "RBY2": 2.2,
    "RCY1": 1.0,
    "RVY4": 20.0,
    "RVY5": 2.0,
    "RVY6": 10.0,
    "QSY1": 0.01,
    "QSY3": 4e-4,
    "QSY4": 4e-5,
    "QSY7": 0.85,
    "QSY8": -0.4,
    "QBZ1": 10.0,
    "QBZ9": 10.0,
    "QCZ1": 1.1,
    "QDZ1": 0.12,
    "QDZ8": -0.05,
}
"""Defaults of a car tyre 205/60R15 as MFeval 4 (M. Furlan, 2020) ships them as the book's; zeros left out."""


def filled(numbers: Mapping[str, float]) -> dict[str, float]:
    """A complete 6.1 set: scales 1 and all else 0 where nothing is given."""
    return {name: float(name in SCALES_61) for name in NAMES_61} | dict(numbers)


def as_61(old: dict[str, float], Fz: float) -> dict[str, float]:
    """The 6.1 set that is the 5.2 set *old* at load *Fz*: its camber stiffness carries the shift PHY3."""
    shared = {name: value for name, value in old.items() if name in NAMES_61}
    new = filled(shared) | {"NOMPRES": 1.0, "INFLPRES": 1.0, "PKY4": 2.0, "QSY7": 1.0}
    _, K, Kyg0 = stiffnesses_52(old, Fz)
    unit = camber_stiffness(new | {"PKY6": 1.0}, tool_point(new, 0.0, 0.0, Fz, 0.0, 1.0))
    assert K < 0
    return new | {"PKY6": Kyg0 / unit}
