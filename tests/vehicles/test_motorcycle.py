"""The motorcycle against R. S. Sharp's equations of 1971, and against what physics says without them.

The referee is the paper's model written out: four coordinates (sideways velocity of the point of the road under the
rear frame's centre of mass, yaw, roll, steer) and two tyre forces that build up over a relaxation length, in its axes
x forward, y right, z down. The machine's numbers, in SI units, and the roots below are those of a public model of the
paper, github.com/aerotinez/trajopt (examples/sharpmotorcycle: its parameters of 1971, its state matrix made by the
Symbolic Math Toolbox); the paper itself was not at hand. It gives the load on the front tyre as a number of its own,
1005.3 N; the weights of the table put 1012.5 N there, and this is what statics finds.

Tolerance 1e-9: the vehicle is assembled from six bodies (two contact patches among them) in 36 coordinates, the
referee has eight states; the roots are simple and differ by rounding alone.
"""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

import eom
from tests.vehicles.shipped import text, vehicle

Array = np.ndarray
g, V0 = 9.81, 30.0
Mr, Mf, Irx, Irz, Crxz, Ifx, Ifz, iry, ify = 217.45, 30.65, 31.18, 21.07, 1.7355, 1.2338, 0.4420, 1.0508, 0.7186
a, an, b, h, e, f, eps, R = 0.9485376, 0.1158, 0.4798, 0.6157, 0.0244, 0.0283, 0.4715, 0.3048
Cf1, Cf2, Cr1, Cr2, sigma, damper = 11174.0, 938.6, 15831.0, 1325.6, 0.2438, 6.77
sin, cos = np.sin(eps), np.cos(eps)
j, k, front = (a + e) * sin - f * cos, (a + e) * cos + f * sin, (a - an) / cos
PUBLISHED_LOAD = 1005.3
PUBLIC_ROOTS = np.array(
    [
        -121.1229633876,
        -109.7387530179,
        -18.8564218905,
        -4.0554938551 - 54.2135297080j,
        -4.0554938551 + 54.2135297080j,
        -1.9684151423 - 19.0999927422j,
        -1.9684151423 + 19.0999927422j,
        0.0725455917,
    ]
)
"""Of the public model's state matrix at 30 m/s with the load 1005.3 N."""
LOAD = g * (Mr * b + Mf * (b + k)) / (front + b)
"""On the front tyre [N], by the lever about the rear one."""
SPEEDS = (1.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0)


def sharp(V: float, load: float = LOAD, *, camber: float = 1.0) -> tuple[Array, Array]:
    """A (8, 8) and b (8,) of states roll, steer, sideways velocity, yaw, roll and steer rate, rear and front force.

    The input is a steering torque. *camber* multiplies both camber stiffnesses.
    """
    M = np.zeros((4, 4))
    M[0] = Mf + Mr, Mf * k, Mf * j + Mr * h, Mf * e
    M[1, 1:] = (
        Mf * k**2 + Irz + Ifx * sin**2 + Ifz * cos**2,
        Mf * j * k - Crxz + (Ifz - Ifx) * sin * cos,
        Mf * e * k + Ifz * cos,
    )
    M[2, 2:] = Mf * j**2 + Mr * h**2 + Irx + Ifx * cos**2 + Ifz * sin**2, Mf * e * j + Ifz * sin
    M[3, 3] = Mf * e**2 + Ifz
    M += np.triu(M, 1).T
    spin_f, spin = ify / R * V, (ify + iry) / R * V
    # of velocities: the centripetal acceleration V times yaw rate, the wheels' gyroscopic moments, the damper
    C = np.array([[0.0, 0, 0, 0], [0, 0, -spin, -spin_f * sin], [0, spin, 0, spin_f * cos], [0, 0, 0, damper]])
    C[:, 1] += V * M[:, 0]
    C[3, 1:3] += spin_f * sin, -spin_f * cos
    lean = Mf * e * g + load * an
    weight = np.array([[0.0, 0], [0, 0], [(Mf * j + Mr * h) * g, lean], [lean, lean * sin]])
    tyres = np.array([[1.0, 1], [-b, front], [0, 0], [0, -an]])
    A, B = np.zeros((8, 8)), np.zeros(8)
    A[0, 4] = A[1, 5] = 1.0
    A[2:6] = np.linalg.solve(M, np.hstack([weight, -C, tyres]))
    B[2:6] = np.linalg.solve(M, [0, 0, 0, 1.0])
    A[6] = np.array([Cr2 * camber * V, 0, -Cr1, Cr1 * b, 0, 0, -V, 0]) / sigma
    steer = (Cf1 * cos + Cf2 * camber * sin) * V
    A[7] = np.array([Cf2 * camber * V, steer, -Cf1, -Cf1 * front, 0, Cf1 * an, 0, -V]) / sigma
    return A, B


def ordered(roots: Array) -> Array:
    """Roots in a fixed order, conjugates next to each other."""
    return roots[np.lexsort((roots.imag, np.round(roots.real, 6)))]


def lateral(model: eom.LinearModel) -> Array:
    """The eight largest roots; the others are exact or all but exact zeros: place, heading, wheels that roll."""
    roots = np.linalg.eigvals(model.without_cyclic().A)
    roots = roots[np.argsort(-np.abs(roots))]
    np.testing.assert_allclose(roots[8:], 0.0, atol=1e-9)
    return ordered(roots[:8])


def test_the_referee_has_the_roots_of_the_public_models_state_matrix() -> None:
    """To the digits written down."""
    np.testing.assert_allclose(ordered(np.linalg.eigvals(sharp(V0, PUBLISHED_LOAD)[0])), PUBLIC_ROOTS, atol=1e-9)


@pytest.mark.parametrize("V", SPEEDS)
def test_roots_are_those_of_sharps_equations(V: float) -> None:
    own = lateral(eom.linearise(vehicle("motorcycle", U=V)))
    np.testing.assert_allclose(own, ordered(np.linalg.eigvals(sharp(V)[0])), rtol=1e-9)


@pytest.mark.parametrize("frequency", [0.1, 1.0, 4.0, 9.0])
def test_steering_torque_answers_as_sharps_equations_say(frequency: float) -> None:
    """Steer and yaw to the left are positive here, to the right in the paper; so is torque. Lean is the same."""
    model = eom.linearise(vehicle("motorcycle", U=V0))
    A, B = sharp(V0)
    answer = np.linalg.solve(2j * np.pi * frequency * np.eye(8) - A, B)[[0, 1, 3]]
    names = [model.outputs.index(name) for name in ("lean", "steer", "yaw_rate")]
    own = model.frequency_response(np.array([frequency]))[0, names, model.inputs.index("steer_torque")]
    np.testing.assert_allclose(own, answer * np.array([-1.0, 1.0, 1.0]), rtol=1e-9)


def test_the_papers_own_front_load_moves_the_roots_by_little() -> None:
    """0.7 % less load, which steers less: roots move by about as much, relative to the largest of an oscillation."""
    assert abs(LOAD / PUBLISHED_LOAD - 1.0) < 0.0075
    for V in SPEEDS[1:]:
        one, other = (np.linalg.eigvals(sharp(V, load)[0]) for load in (LOAD, PUBLISHED_LOAD))
        assert np.max(np.abs(ordered(one) - ordered(other))) < 0.0075 * np.max(np.abs(one.imag))


def mode(roots: Array, low: float, high: float) -> complex:
    """The one oscillation with a frequency between two in Hz."""
    found = roots[(roots.imag > 2 * np.pi * low) & (roots.imag < 2 * np.pi * high)]
    assert len(found) == 1
    return complex(found[0])


def capsize(roots: Array) -> float:
    """The rightmost root that is no oscillation."""
    return float(np.max(roots[np.abs(roots.imag) < 1e-9].real))


@pytest.mark.parametrize("V", [20.0, 30.0, 40.0, 50.0, 60.0])
def test_weave_wobble_and_capsize_are_three_modes_of_their_own(V: float) -> None:
    roots = lateral(eom.linearise(vehicle("motorcycle", U=V)))
    weave, wobble = mode(roots, 1.0, 5.0), mode(roots, 6.0, 12.0)
    assert wobble.imag > 2 * weave.imag
    real = roots[np.abs(roots.imag) < 1e-9].real
    # capsize: one slow real root, far from all others
    assert np.sum(np.abs(real) < 1.5) == 1


@pytest.mark.parametrize(
    ("what", "low", "high"),
    [
        (lambda roots: mode(roots, 0.05, 2.0).real, 5.0, 10.0),
        (capsize, 8.0, 15.0),
        (lambda roots: mode(roots, 6.0, 12.0).real, 40.0, 60.0),
    ],
    ids=["weave", "capsize", "wobble"],
)
def test_modes_change_their_stability_at_the_speeds_of_sharps_equations(
    what: Callable[[Array], float], low: float, high: float
) -> None:
    """Slow weave ends, capsize begins, wobble begins; roots to 1e-9 give speeds to 1e-7 where they cross slowly."""
    own = brentq(lambda V: what(lateral(eom.linearise(vehicle("motorcycle", U=V)))), low, high, xtol=1e-10)
    assert own == pytest.approx(brentq(lambda V: what(np.linalg.eigvals(sharp(V)[0])), low, high, xtol=1e-10), rel=1e-7)


def test_without_camber_thrust_the_roots_are_others_and_again_those_of_sharps_equations() -> None:
    bare = text("motorcycle").replace("camber: 1325.6 N/rad, ", "").replace("camber: 938.6 N/rad, ", "")
    own = lateral(eom.linearise(eom.loads(bare)))
    np.testing.assert_allclose(own, ordered(np.linalg.eigvals(sharp(V0, camber=0.0)[0])), rtol=1e-9)
    assert np.max(np.abs(ordered(np.linalg.eigvals(sharp(V0)[0])) - own)) > 0.1


def test_springs_under_the_wheels_leave_the_lateral_motion_as_it_is() -> None:
    """Out of the plane and in it are apart for a symmetric machine; springs add roots and change none of the eight.

    The tolerance is the eigenvalue solver's with tyre springs of 1e5 N/m beside.
    """
    lines = [
        line for line in text("motorcycle").splitlines() if not line.startswith(("  rear_contact", "  front_contact"))
    ]
    sprung = "\n".join(lines).replace("relaxation: 0.2438 m}", "relaxation: 0.2438 m, vertical_stiffness: 115 kN/m}")
    roots = np.linalg.eigvals(eom.linearise(eom.loads(sprung)).without_cyclic().A)
    for root in np.linalg.eigvals(sharp(V0)[0]):
        assert np.min(np.abs(roots - root)) < 1e-8 * abs(root)
