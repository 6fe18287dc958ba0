"""A train without height against exact motion in the plane: the model is right to the second order of its angles.

Lateral motion is odd in the angles and forward motion even. So the error of one is of the third order, of the other at
most of the second; relative to the motion, either shrinks by four or more when all angles are halved.
"""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.splice.flat_train import Pair, pair
from tests.splice.shared import Array, by_name, places

ANGLES = (0.08, 0.04, 0.02, 0.01)
STEERS = {"rolling": (4.0, 2.0, 1.0, 0.5), "braked": (4.0, 2.0), "driven": (4.0, 2.0)}
KINDS = {"rolling": {}, "braked": {"every_brake_pressure": 2e5}, "driven": {"drive_torque": 1.5e4}}


@cache
def both() -> Pair:
    """The model and its referee."""
    return pair()


def test_the_straight_run_is_that_of_the_referee() -> None:
    """Rates but those of the path vanish: rounding of forces of 1e4 N on wheels of 20 kg m^2. Seen are 3e-14."""
    run = both().model.trim()
    rate = both().referee_rates(both().of_referee(run.x), run.u)
    np.testing.assert_allclose(rate[2:], 0.0, atol=1e-11)


@pytest.mark.parametrize("slip", [-0.04, 0.0, 0.03])
@pytest.mark.parametrize("seed", range(3))
def test_accelerations_are_right_to_the_second_order_of_the_angles(seed: int, slip: float) -> None:
    """Random articulation, slip, yaw rates and steer of a size, at any heading; wheels that slip by drive or brakes."""
    found = both()
    at, run, random = places(found.model), found.model.trim(), np.random.default_rng(seed)
    size = np.zeros(len(run.x))
    size[at["q"]] = random.uniform(-1.0, 1.0, 2)
    size[at["n"]] = random.uniform(-1.0, 1.0, 5) * [0.0, 10.0, 1.0, 1.0, 1.0]
    steer, share = random.uniform(-0.7, 0.7), random.uniform(0.5, 1.0, 9)
    errors = []
    for angle in ANGLES:
        x, u = run.x + angle * size, run.u + by_name(found.model, axle_1__steer=angle * steer)
        x[2], x[at["spin"]] = 1.0, x[at["spin"]] * (1.0 + slip * share)
        exact = found.referee_rates(found.of_referee(x), u)
        errors.append(np.abs(found.of_referee(found.model.rhs(0.0, x, u)) - exact)[5:])
    forward, sideward, turning = (np.array(errors)[:, own] for own in (0, 1, slice(2, 5)))
    assert np.max(forward[0]) < 0.01
    assert np.max(sideward[0]) < 0.01
    assert np.max(turning[0]) < 0.005
    # halved three times: orders to a tenth, as the next ones are two higher and the angles below 0.04
    for error, order in ((forward, 2.0), (sideward, 3.0), (np.max(turning, axis=1), 3.0)):
        assert np.all(np.log2(error[1:-1] / error[2:]) > order - 0.1), error


class Difference(NamedTuple):
    """Largest difference of two motions over the largest of the motion; speed over the change of speed in m/s."""

    ay: float
    yaw_rate: float
    articulation: float
    speed: float


def difference(found: Pair, steer: float, signals: dict[str, float]) -> Difference:
    """Of model and referee over a sine of steer of 2 s and 1 s more, an amplitude in degrees, the rest ramped up."""
    model, run = found.model, found.model.trim()
    times = np.linspace(0.0, 3.0, 31)

    def inputs(t: float) -> Array:
        turned = by_name(model, axle_1__steer=np.radians(steer) * np.sin(np.pi * t))
        return np.asarray(run.u + turned + by_name(model, **signals) * min(t, 1.0))

    def solved(rates: Callable[[float, Array], Array], start: Array) -> Array:
        result = solve_ivp(rates, (0.0, 3.0), start, "LSODA", times, rtol=1e-8, atol=1e-9)
        assert result.success
        return np.asarray(result.y.T)

    own = solved(lambda t, x: model.rhs(t, x, inputs(t)), run.x)
    exact = solved(lambda t, state: found.referee_rates(state, inputs(t)), found.of_referee(run.x))
    ay = [model.outputs.index(f"{name}.ay") for name in ("tractor", "semitrailer_1", "semitrailer_2")]
    mine = np.array([model.output(0.0, x, inputs(t))[ay] for t, x in zip(times, own, strict=True)])
    theirs = np.array([found.referee(s, inputs(t)).acceleration[:, 1] for t, s in zip(times, exact, strict=True)])
    own = np.array([found.of_referee(x) for x in own])

    def relative(one: Array, two: Array) -> float:
        return float(np.max(np.abs(one - two)) / np.max(np.abs(two)))

    return Difference(
        relative(mine, theirs),
        relative(own[:, 7:10], exact[:, 7:10]),
        relative(np.diff(own[:, 2:5]), np.diff(exact[:, 2:5])),
        float(np.max(np.abs(own[:, 5] - exact[:, 5]))),
    )


@pytest.mark.parametrize("kind", KINDS)
def test_manoeuvres_are_right_to_the_second_order_of_the_steer(kind: str) -> None:
    """At 4 deg, where the train turns with 0.47 g and articulates by 7 deg, up to 0.7 % is wrong.

    A quarter of that is left at each halving: seen are 4.0 to 6.2, most at the top, where tyres are not linear any
    more. The speed, even in the steer, is better than its second order: 13 to 16. Motions are integrated to 1e-8.
    """
    found = np.array([difference(both(), steer, KINDS[kind]) for steer in STEERS[kind]])
    assert np.all(found[0] < Difference(0.008, 0.006, 0.005, 0.002))
    ratios = found[:-1, :3] / found[1:, :3]
    assert np.all(ratios > 3.9), ratios
    assert np.all(found[:-1, 3] / found[1:, 3] > 12.0)
