"""Braking of single units: hitches push or pull, and the load shifts. Both move the lateral roots of the B-train.

A braked run is no trim: its roots are those of the equations frozen at an instant, without place, speed and spins. They
are compared with those of the linear kernel for the same train without spins, on which the brakes' forces act as loads,
and against them d'Alembert's along the heading of the lead unit.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import eom
from eom.model.tyre import Run, TyreModel, build_tyre_model, tyre_slopes
from eom.vehicle.elements import Load
from tests.splice.shared import STEP, Array, by_name, places
from tests.vehicles.shipped import FOLDER, text, vehicle

TRACTOR, TRAILERS = (1, 2, 3), (4, 5, 6, 7, 8, 9)
ODD = (".roll", ".yaw", ".v_y", ".roll_rate", ".yaw_rate")


@cache
def train(linear: bool) -> TyreModel:
    """The B-train without rolling resistance; with *linear* tyres stiffnesses do not follow the load."""
    lines = [line for line in text("b_train").splitlines() if not (linear and "nonlinear: &law" in line)]
    written = "\n".join(lines)
    if linear:
        written = written.replace(", nonlinear: *law", "")
    found = build_tyre_model(eom.loads(written, str(FOLDER / "b_train.yaml"), f_r=0.0))
    assert {law.kind for law in found.prepared.system.tyres} == {"linear" if linear else "magic_formula"}
    return found


def pressing(found: TyreModel, axles: tuple[int, ...]) -> Array:
    """Inputs that brake the wheels of axles by 1 Pa."""
    names = [f"axle_{axle}.{side}.brake_pressure" for axle in axles for side in ("left", "right")]
    return by_name(found, **{name.replace(".", "__"): 1.0 for name in names})


def braked(found: TyreModel, axles: tuple[int, ...], deceleration: float) -> Run:
    """The straight run at an instant of a braking [m/s^2] by some axles, spins in proportion to the speed."""
    x, at, per = found.trim().x, places(found), pressing(found, axles)
    spin, speed = x[at["spin"]], x[at["n"]][0]

    def left(z: Array) -> Array:
        """What is missing, of spins and of the deceleration; the pressure counts in 0.5 MPa."""
        moved = x.astype(z.dtype)
        moved[at["spin"]] = spin * z[:-1]
        rate = found.rhs(0.0, moved, 5e5 * per * z[-1])
        slowing = rate[at["n"]][0]
        return np.asarray(np.append(rate[at["spin"]] - moved[at["spin"]] * slowing / speed, slowing + deceleration))

    z = np.ones(len(spin) + 1)
    z[-1] = 0.5
    for _ in range(30):
        if np.max(np.abs(left(z))) < 1e-9:
            x[at["spin"]] = spin * z[:-1]
            return Run(x, 5e5 * per * z[-1])
        slopes = np.array([left(z + 1j * STEP * each).imag / STEP for each in np.eye(len(z))]).T
        z = z - np.linalg.solve(slopes, left(z))
    raise AssertionError(axles)


def dominant(found: TyreModel, run: Run) -> complex:
    """The root of lateral motion that decays most slowly, of those that oscillate [1/s]."""
    names = [name.partition("_from_")[0] for name in found.states]
    kept = [k for k, name in enumerate(names) if k >= 3 and name.endswith(ODD)]
    roots = np.linalg.eigvals(tyre_slopes(found, *run)[0][np.ix_(kept, kept)])
    oscillating = roots[roots.imag > 0.3]
    return complex(oscillating[np.argmax(oscillating.real)])


def by_kernel(axles: tuple[int, ...], deceleration: float) -> complex:
    """The same root of the linear kernel; forces act on the road and along the lead's heading."""
    twin = vehicle("b_train_yaw_roll", U="110 km/h")
    system, none = twin.system, (0.0, 0.0, 0.0)
    mass, wheels = sum(body.mass for body in system.bodies), [system.wheels[axle - 1] for axle in axles]
    brakes = [
        Load(f"{w.name}.brake", w.body, w.place, (-deceleration * mass / len(axles), 0.0, 0.0), none, w.body)
        for w in wheels
    ]
    inertia = [
        Load(f"{body.name}.inertia", k, body.centre, (deceleration * body.mass, 0.0, 0.0), none, 0)
        for k, body in enumerate(system.bodies)
    ]
    loaded = system._replace(loads=(*system.loads, *brakes, *inertia))
    roots = np.linalg.eigvals(eom.linearise(replace(twin, system=loaded)).without_cyclic().A)
    oscillating = roots[roots.imag > 0.3]
    return complex(oscillating[np.argmax(oscillating.real)])


@pytest.mark.parametrize(
    ("axles", "towards"), [(TRACTOR, complex(0.094, -0.249)), (TRAILERS, complex(-0.080, 0.021))], ids=("push", "pull")
)
def test_roots_move_as_hitches_push_and_pull(axles: tuple[int, ...], towards: complex) -> None:
    """Linear tyres, 2 m/s^2 at 110 km/h: from -1.318 + 2.077i to -1.224 + 1.829i if the tractor alone brakes.

    Trailers that brake alone stretch the train, which does the opposite. Slips of left and right wheels, whose spins
    are held, resist yaw, and loads of slipping wheels turn with them: that is 0.6 % of the root, and 2 % of its shift.
    """
    found, resting = train(linear=True), by_kernel((), 0.0)
    rolling = dominant(found, found.trim())
    assert abs(resting - complex(-1.318, 2.077)) < 1e-3
    assert abs(rolling - resting) < 0.01 * abs(resting)
    moved, expected = dominant(found, braked(found, axles, 2.0)) - rolling, by_kernel(axles, 2.0) - resting
    assert abs(expected - towards) < 1e-3
    assert abs(moved - expected) < 0.05 * abs(expected)


def articulation(linear: bool) -> Array:
    """Articulation of the first hitch [rad] at 2, 3 and 4 s of braking the tractor alone by 2 m/s^2.

    At 1 s the front wheels are turned by up to 1 mrad for half a second.
    """
    found = train(linear)
    pressure, start = braked(found, TRACTOR, 2.0).u, found.trim()

    def rates(t: float, x: Array) -> Array:
        pulse = np.sin(2.0 * np.pi * (t - 1.0)) ** 2 if 1.0 < t < 1.5 else 0.0
        return found.rhs(0.0, x, pressure * min(t / 0.2, 1.0) + by_name(found, axle_1__steer=1e-3 * pulse))

    run = solve_ivp(rates, (0.0, 4.0), start.x, "LSODA", (2.0, 3.0, 4.0), rtol=1e-6, atol=1e-8, max_step=0.05)
    assert run.success
    return np.asarray(run.y[found.states.index("semitrailer_1_frame.yaw_from_tractor_frame")])


def test_tyres_that_follow_their_load_fold_up_a_train_braked_by_its_tractor() -> None:
    """After a small pulse of steer articulation decays with linear tyres, and grows with those of the file.

    Braked tyres of the tandem, from which the deceleration takes load, have little side force left. Seen are 5 % of the
    articulation after two seconds with the ones, and with the others more than twice of it every second.
    """
    steady, growing = np.abs(articulation(linear=True)), np.abs(articulation(linear=False))
    assert steady[2] < 0.2 * steady[0]
    assert np.all(growing[1:] > 1.5 * growing[:-1])
    assert growing[0] > 5e-4
