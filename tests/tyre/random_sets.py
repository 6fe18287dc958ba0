"""Random coefficient sets of the Magic Formula with no coefficient zero, and random states of a wheel.

A seed gives the same set everywhere. The ranges are those of car tyres, widened, so that every denominator and the
weight at no slip stay away from zero and the curvature factors below 1 over the states drawn.
"""

from typing import NamedTuple

import numpy as np

SCALES_61 = (
    *("LFZO", "LCX", "LMUX", "LEX", "LKX", "LHX", "LVX", "LCY", "LMUY", "LEY", "LKY", "LHY", "LVY", "LTR", "LRES"),
    *("LXAL", "LYKA", "LVYKA", "LS", "LKYC", "LKZC", "LVMX", "LMX", "LMY"),
)
SCALES_52 = (*SCALES_61, "LGAX", "LGAY", "LGAZ", "LSGKP", "LSGAL")

SHARED = {
    "UNLOADED_RADIUS": (0.29, 0.35),
    "FNOMIN": (3500.0, 4500.0),
    "LONGVL": (15.0, 18.0),
    "PCX1": (1.4, 1.7),
    "PDX1": (0.95, 1.25),
    "PEX1": (-0.8, -0.2),
    "PKX1": (18.0, 26.0),
    "RBX1": (10.0, 14.0),
    "RBX2": (8.0, 12.0),
    "RCX1": (1.0, 1.1),
    "REX1": (-0.7, -0.3),
    "PCY1": (1.2, 1.5),
    "PDY1": (0.85, 1.1),
    "PEY1": (-1.5, -0.9),
    "PKY1": (-22.0, -14.0),
    "PKY2": (1.5, 2.2),
    "RBY1": (7.0, 11.0),
    "RBY2": (5.0, 9.0),
    "RCY1": (1.0, 1.1),
    "REY1": (-0.5, -0.2),
    "RVY4": (8.0, 20.0),
    "RVY5": (1.5, 2.0),
    "RVY6": (8.0, 20.0),
    "QBZ1": (8.0, 12.0),
    "QBZ9": (8.0, 20.0),
    "QBZ10": (0.2, 0.5),
    "QCZ1": (1.1, 1.3),
    "QDZ1": (0.09, 0.13),
    "QEZ1": (-2.5, -1.8),
    "QSX2": (0.5, 1.0),
    "QSY1": (0.006, 0.012),
}
"""Ranges of coefficients that have to keep their sign and size."""

SMALL = {
    "PDX2": 0.08,
    "PDX3": 2.0,
    "PEX2": 0.1,
    "PEX3": 0.05,
    "PEX4": 0.15,
    "PKX2": 3.0,
    "PKX3": 0.25,
    "PHX1": 2e-3,
    "PHX2": 1e-3,
    "PVX1": 0.02,
    "PVX2": 0.01,
    "REX2": 0.1,
    "RHX1": 0.01,
    "PDY2": 0.08,
    "PDY3": 2.0,
    "PEY2": 0.2,
    "PEY3": 0.2,
    "PEY4": 1.0,
    "PKY3": 0.5,
    "PHY1": 4e-3,
    "PHY2": 3e-3,
    "PVY1": 0.03,
    "PVY2": 0.03,
    "PVY3": 0.2,
    "PVY4": 0.2,
    "RBY3": 0.03,
    "REY2": 0.1,
    "RHY1": 0.02,
    "RHY2": 0.01,
    "RVY1": 0.05,
    "RVY2": 0.03,
    "RVY3": 0.3,
    "QBZ2": 1.0,
    "QBZ3": 0.4,
    "QBZ4": 0.3,
    "QBZ5": 0.3,
    "QDZ2": 0.01,
    "QDZ3": 0.6,
    "QDZ4": 1.0,
    "QDZ6": 4e-3,
    "QDZ7": 3e-3,
    "QDZ8": 0.15,
    "QDZ9": 0.1,
    "QEZ2": 0.3,
    "QEZ3": 0.1,
    "QEZ4": 0.2,
    "QEZ5": 0.5,
    "QHZ1": 4e-3,
    "QHZ2": 3e-3,
    "QHZ3": 0.15,
    "QHZ4": 0.1,
    "SSZ1": 0.02,
    "SSZ2": 0.03,
    "SSZ3": 0.1,
    "SSZ4": 0.1,
    "QSX1": 0.01,
    "QSX3": 0.03,
    "QSY2": 0.003,
    "QSY3": 0.002,
    "QSY4": 1e-4,
}
"""Largest size of coefficients that may have either sign; none is drawn below a third of it."""

ONLY_61 = {
    "NOMPRES": (2.1e5, 2.3e5),
    "INFLPRES": (1.7e5, 2.0e5),
    "LMUV": (0.05, 0.15),
    "PKY4": (1.7, 2.0),
    "QSX5": (0.8, 1.2),
    "QSX6": (0.8, 2.0),
    "QSX7": (0.3, 0.6),
    "QSX8": (0.3, 0.6),
    "QSX9": (0.4, 0.8),
    "QSX11": (0.3, 0.8),
    "QSY7": (0.8, 1.1),
    "QSY8": (-0.5, -0.3),
    "LONGITUDINAL_STIFFNESS": (3e5, 4e5),
    "LATERAL_STIFFNESS": (1e5, 2e5),
}

SMALL_61 = {
    "PPX1": 0.4,
    "PPX2": 0.4,
    "PPX3": 0.2,
    "PPX4": 0.3,
    "RBX3": 5.0,
    "PEY5": 1.0,
    "PKY5": 1.0,
    "PKY6": 0.9,
    "PKY7": 0.3,
    "PPY1": 0.5,
    "PPY2": 0.5,
    "PPY3": 0.2,
    "PPY4": 0.3,
    "PPY5": 0.4,
    "RBY4": 5.0,
    "QBZ6": 1.0,
    "QDZ10": 0.3,
    "QDZ11": 0.2,
    "PPZ1": 0.5,
    "PPZ2": 0.5,
    "QSX4": 0.1,
    "QSX10": 0.2,
    "QSX12": 0.5,
    "QSX13": 0.03,
    "QSX14": 0.1,
    "PPMX1": 0.5,
    "QSY5": 0.02,
    "QSY6": 0.01,
    "PCFX1": 0.2,
    "PCFX2": 0.05,
    "PCFX3": 0.3,
    "PCFY1": 0.2,
    "PCFY2": 0.05,
    "PCFY3": 0.3,
}

ONLY_52 = {"PTX1": (1.5, 2.5), "PTX2": (0.2, 0.5), "PTX3": (0.1, 0.3), "PTY1": (1.8, 2.6), "PTY2": (1.5, 2.2)}
SMALL_52 = {"PHY3": 0.04}

NAMES_61 = (*SHARED, *ONLY_61, *SMALL, *SMALL_61, *SCALES_61)
NAMES_52 = (*SHARED, *ONLY_52, *SMALL, *SMALL_52, *SCALES_52)

WITHOUT_EFFECT = {
    # The tool has QBZ4 where the book has QBZ6 (A58, 4.E40) and no friction that decays with slip speed.
    "tool": {"QBZ6", "LMUV"},
    # 4.E40 has no QBZ4, and 4.E69 none of the three terms of the draft.
    "book": {"QBZ4", "QSX12", "QSX13", "QSX14"},
    "5.2": set[str](),
}
"""Coefficients that a form knows and does not use."""


class State(NamedTuple):
    """What a tyre is asked for, in the order of the referee's arguments."""

    alpha: float
    kappa: float
    Fz: float
    gamma: float
    speed: float


def either_sign(rng: np.random.Generator) -> float:
    return -1.0 if rng.uniform() < 0.5 else 1.0


def drawn(
    rng: np.random.Generator, ranges: dict[str, tuple[float, float]], sizes: dict[str, float], scales: tuple[str, ...]
) -> dict[str, float]:
    numbers = {name: rng.uniform(*limits) for name, limits in ranges.items()}
    numbers |= {name: either_sign(rng) * rng.uniform(size / 3, size) for name, size in sizes.items()}
    return numbers | {name: 1.0 + either_sign(rng) * rng.uniform(0.05, 0.15) for name in scales}


def random_set_61(seed: int) -> dict[str, float]:
    return drawn(np.random.default_rng([61, seed]), SHARED | ONLY_61, SMALL | SMALL_61, SCALES_61)


def random_set_52(seed: int) -> dict[str, float]:
    return drawn(np.random.default_rng([52, seed]), SHARED | ONLY_52, SMALL | SMALL_52, SCALES_52)


def random_states(seed: int, FNOMIN: float, count: int) -> list[State]:
    """States from slow to fast, small to large slip, nearly lifted to overloaded; slips crowd towards zero.

    The tread runs faster than 1 m/s, the largest VXLOW of the sets: below it rolling resistance fades.
    """
    rng = np.random.default_rng([1, seed])

    def state() -> State:
        speed = rng.uniform(3, 60)
        return State(
            alpha=rng.uniform(-1, 1) ** 3,
            kappa=max(rng.uniform(-0.95, 1) * rng.uniform(), 1.01 / speed - 1.0),
            Fz=FNOMIN * rng.uniform(0.1, 2.5),
            gamma=rng.uniform(-0.3, 0.3),
            speed=speed,
        )

    return [state() for _ in range(count)]
