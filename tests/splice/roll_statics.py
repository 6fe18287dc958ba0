"""Roll of the B-train in a steady turn by hand: moments about the roll axis of each unit, loads by levers.

Numbers are those of Appendix B of S. Zhu's thesis. Angles are positive outward, forces on a unit inward. Every unit
has the same lateral acceleration; a unit's road forces act at the middle of its axles, as do their loads.
"""

from typing import NamedTuple

import numpy as np

G, H_ROLL, H_HITCH, K_HITCH = 9.8, 0.705, 1.1, 550e3


class Unit(NamedTuple):
    """Masses, stiffnesses and lengths of a unit.

    Sprung and unsprung (mass, height, place behind the first axle or the hitch ahead), roll stiffness of the suspension
    and of the tyres, place of the axles and of the hitch behind, track.
    """

    sprung: tuple[float, float, float]
    unsprung: tuple[float, float, float]
    suspension: float
    tyres: float
    axles: float
    hitch: float
    track: float


TRACTOR = Unit((6308, 1.019, 1.384), (1950, 0.519, 3.98845), 1.8e6, 2.4e6, 0.0, 5.635, 0.0)
FIRST = Unit((15927, 1.555, 6.385), (2070, 0.51, 11.4972), 2.0e6, 6.0e6, 11.5, 12.57, 1.65)
SECOND = Unit((15927, 1.555, 6.385), (2070, 0.51, 11.4972), 2.2e6, 5.2e6, 11.5, 0.0, 1.65)


def shares() -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Masses that the road carries at the axles of the three units, and that hitches pass on [kg]."""
    passed = 0.0
    road: list[float] = []
    hitches: list[float] = []
    for unit in (SECOND, FIRST):
        masses = unit.sprung[0] + unit.unsprung[0] + passed
        moment = unit.sprung[0] * unit.sprung[2] + unit.unsprung[0] * unit.unsprung[2] + passed * unit.hitch
        road.insert(0, moment / unit.axles)
        passed = masses - moment / unit.axles
        hitches.insert(0, passed)
    return (TRACTOR.sprung[0] + TRACTOR.unsprung[0] + passed, *road), tuple(hitches)


def lift(saturated: bool) -> tuple[float, float]:
    """Lateral accelerations [g] at which the inner wheels of the second and of the first semitrailer lift.

    With *saturated* the second one's are in the air: its tyres give their largest moment and no more.
    """
    road, hitches = shares()
    units, arm = (TRACTOR, FIRST, SECOND), H_HITCH - H_ROLL
    stiffness, push = np.zeros((6, 6)), np.zeros(6)
    constant = np.zeros(6)
    behind, ahead = (*hitches, 0.0), (0.0, *hitches)
    for k, unit in enumerate(units):
        frame, axles = 2 * k, 2 * k + 1
        sprung, unsprung = unit.sprung[0] * (unit.sprung[1] - H_ROLL), unit.unsprung[0] * (unit.unsprung[1] - H_ROLL)
        at_hitches = (behind[k] - ahead[k]) * arm
        push[frame] = sprung + at_hitches
        push[axles] = unsprung + road[k] * H_ROLL
        stiffness[frame, frame] -= G * (sprung + at_hitches)
        stiffness[axles, axles] -= G * unsprung
        if saturated and unit is SECOND:
            constant[axles] = -G * road[k] * unit.track / 2.0
        else:
            stiffness[axles, axles] += unit.tyres
        between = [(frame, axles, unit.suspension)]
        if k < 2:
            between.append((frame, frame + 2, K_HITCH))
        for one, two, value in between:
            stiffness[[one, two], [one, two]] += value
            stiffness[[one, two], [two, one]] -= value
    per_g, fixed = np.linalg.solve(stiffness, G * push), np.linalg.solve(stiffness, constant)
    limit = [G * road[k] * units[k].track / 2.0 / units[k].tyres for k in (2, 1)]
    second, first = (float((limit[j] - fixed[axles]) / per_g[axles]) for j, axles in ((0, 5), (1, 3)))
    return second, first
