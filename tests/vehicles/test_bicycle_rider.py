"""The bicycle with a leaning rider against its published linear model, and against the benchmark equations.

The published model is the one of the package BicycleParameters (`MooreRiderLean2012Model`), whose documentation prints
A and B at 4 m/s without stiffness and damping of the waist. Its axes are x forward, y right, z down: lean and the
rider's lean have the same sign here, steer the other one. Tolerance of comparisons with it: its nine printed digits,
which leave 2e-7 of a root or transfer function (found 3e-8; the rows of steer are sums of larger terms).

The benchmark equations, for the rider as part of the frame, are those of J. P. Meijaard, J. M. Papadopoulos, A. Ruina
and A. L. Schwab, Proc. R. Soc. A 463 (2007) 1955-1982, appendix A. Tolerance 1e-9: other algebra, simple roots.
"""

import numpy as np
import pytest

import eom
from tests.vehicles.shipped import text, vehicle

Array = np.ndarray
k_waist, c_waist = 128.0, 50.0
PRINTED = np.array(
    [
        [1.11095692e01, -1.52341011e01, -8.46683843e00, -2.04638864e-01, -1.34590803e00, 0.0],
        [1.04939762e01, 5.61738098e00, 1.68341653e01, 8.26892076e00, -1.01980345e01, 0.0],
        [-1.47851073e01, 2.03755703e01, 5.11495540e01, 4.37754540e-01, 2.54094086e00, 0.0],
    ]
)
"""Second rates of lean, steer and rider's lean by these three and their rates, at 4 m/s."""
PRINTED_B = np.array(
    [
        [0.02883808, -0.11361237, -0.09393174],
        [-0.11361237, 4.59077823, 0.24303462],
        [-0.09393174, 0.24303462, 0.48717313],
    ]
)
"""The same by lean torque, steer torque and waist torque."""
PRINTED_YAW = np.array([0.0, 3.28701304, 0.0, 0.0, 5.63565404e-02, 0.0])
SIGN = np.array([1.0, -1.0, 1.0])
INPUTS, OUTPUTS = ("lean_torque", "steer_torque", "waist_torque"), ("lean", "steer", "rider_lean")


def published(k: float, c: float) -> Array:
    """A (6, 6) of the printed model with a stiffness and damping that act as a torque of the waist."""
    A = np.vstack([np.hstack([np.zeros((3, 3)), np.eye(3)]), PRINTED])
    A[3:, 2] -= k * PRINTED_B[:, 2]
    A[3:, 5] -= c * PRINTED_B[:, 2]
    return A


def ordered(roots: Array) -> Array:
    """Roots in a fixed order, conjugates next to each other."""
    return roots[np.lexsort((roots.imag, np.round(roots.real, 5)))]


def roots_of(model: eom.LinearModel, count: int) -> Array:
    """The largest roots; the rest are zeros of position, heading and rolling."""
    roots = np.linalg.eigvals(model.without_cyclic().A)
    roots = roots[np.argsort(-np.abs(roots))]
    np.testing.assert_allclose(roots[count:], 0.0, atol=1e-8)
    return ordered(roots[:count])


@pytest.mark.parametrize(("k", "c"), [(0.0, 0.0), (k_waist, c_waist)], ids=["free waist", "waist of the file"])
def test_roots_are_those_of_the_published_model(k: float, c: float) -> None:
    own = roots_of(eom.linearise(vehicle("bicycle_rider", k_waist=k, c_waist=c)), 6)
    np.testing.assert_allclose(own, ordered(np.linalg.eigvals(published(k, c))), rtol=2e-7)


@pytest.mark.parametrize(("k", "c"), [(0.0, 0.0), (k_waist, c_waist)], ids=["free waist", "waist of the file"])
@pytest.mark.parametrize("s", [0.5j, 3.0j, 1.0 + 10.0j])
def test_torques_move_lean_steer_and_rider_as_published(k: float, c: float, s: complex) -> None:
    model = eom.linearise(vehicle("bicycle_rider", k_waist=k, c_waist=c))
    own = model.C @ np.linalg.solve(s * np.eye(len(model.A)) - model.A, model.B) + model.D
    columns = [model.inputs.index(name) for name in INPUTS]
    B = np.vstack([np.zeros((3, 3)), PRINTED_B])
    states = np.linalg.solve(s * np.eye(6) - published(k, c), B)
    expected = SIGN[:, np.newaxis] * states[:3] * SIGN
    found = own[np.ix_([model.outputs.index(name) for name in OUTPUTS], columns)]
    np.testing.assert_allclose(found, expected, atol=2e-7 * np.max(np.abs(expected)))
    yaw = own[model.outputs.index("yaw_rate"), columns]
    by_rates = -(PRINTED_YAW @ states) * SIGN
    np.testing.assert_allclose(yaw, by_rates, atol=2e-7 * np.max(np.abs(by_rates)))


class Part:
    """Mass [kg], place of its centre (x, height) [m] and inertia: xx, zz and the positive integral of x z dm."""

    def __init__(self, m: float, x: float, z: float, xx: float, zz: float, xz: float) -> None:
        self.m, self.x, self.z, self.xx, self.zz, self.xz = m, x, z, xx, zz, xz

    def __add__(self, other: "Part") -> "Part":
        m = self.m + other.m
        x, z = ((self.m * p + other.m * q) / m for p, q in ((self.x, other.x), (self.z, other.z)))
        sums = np.zeros(3)
        for one in (self, other):
            dx, dz = one.x - x, one.z - z
            sums += np.array([one.xx + one.m * dz**2, one.zz + one.m * dx**2, one.xz + one.m * dx * dz])
        return Part(m, x, z, *(float(each) for each in sums))


w, trail, tilt, r_rear, r_front, g = 1.121, 0.0685808540382, 0.399680398707, 0.340958858855, 0.34352982332, 9.81
REAR = Part(33.044, 0.374570794542, 0.681592725778, 2.18917391377, 1.61787114693, -0.27087131147)
TORSO = Part(48.816, 0.231223496809401, 1.283035074598082, 2.038073562525466, 1.100753962972129, 0.002113501449812)
FORK = Part(3.22, 0.866949640247, 0.748236400835, 0.253379594731, 0.0955770796289, -0.0720452391817)
REAR_WHEEL = Part(3.11, 0.0, r_rear, 0.0904106601579, 0.0904106601579, 0.0)
FRONT_WHEEL = Part(2.02, w, r_front, 0.0883819364527, 0.0883819364527, 0.0)


def benchmark(v: float) -> Array:
    """A (4, 4) of the benchmark's lean and steer equations, the torso a part of the rear frame.

    Heights are positive up here; the benchmark's z is down, and its xz entry of the tensor is the integral for z up.
    """
    whole, front = REAR + TORSO + REAR_WHEEL + FORK + FRONT_WHEEL, FORK + FRONT_WHEEL
    sine, cosine = np.sin(tilt), np.cos(tilt)
    Txx, Tzz = whole.xx + whole.m * whole.z**2, whole.zz + whole.m * whole.x**2
    Txz = whole.xz + whole.m * whole.x * whole.z
    u = (front.x - w - trail) * cosine + front.z * sine
    A_ll = front.m * u**2 + front.xx * sine**2 + 2 * front.xz * sine * cosine + front.zz * cosine**2
    A_lx = front.m * u * front.z + front.xx * sine + front.xz * cosine
    A_lz = front.m * u * front.x + front.xz * sine + front.zz * cosine
    mu = trail / w * cosine
    S_R, S_F = 0.152467620286 / r_rear, 0.149389340425 / r_front
    S_T, S_A = S_R + S_F, front.m * u + mu * whole.m * whole.x
    M = np.array([[Txx, A_lx + mu * Txz], [A_lx + mu * Txz, A_ll + 2 * mu * A_lz + mu**2 * Tzz]])
    K0 = -np.array([[whole.m * whole.z, S_A], [S_A, S_A * sine]])
    K2 = np.array([[0.0, (S_T + whole.m * whole.z) / w * cosine], [0.0, (S_A + S_F * sine) / w * cosine]])
    C1 = np.array(
        [
            [0.0, mu * S_T + S_F * cosine + Txz / w * cosine + mu * whole.m * whole.z],
            [-(mu * S_T + S_F * cosine), A_lz / w * cosine + mu * (S_A + Tzz / w * cosine)],
        ]
    )
    lower = -np.linalg.solve(M, np.hstack([g * K0 + v**2 * K2, v * C1]))
    return np.vstack([np.hstack([np.zeros((2, 2)), np.eye(2)]), lower])


@pytest.mark.parametrize("v", [1.0, 4.0, 7.0, 12.0])
def test_with_a_rigid_waist_it_is_the_benchmark_bicycle(v: float) -> None:
    start, end = text("bicycle_rider").split("  waist: {")
    rigid = start + "  waist: {" + end.replace("moments: 2, axis: [1, 0, 0]}", "moments: 3}", 1)
    muscles = rigid[rigid.index("  waist_muscles:") : rigid.index("  rear_contact:")]
    model = eom.linearise(eom.loads(rigid.replace(muscles, "").replace("    moments: 3", ""), U=v))
    np.testing.assert_allclose(roots_of(model, 4), ordered(np.linalg.eigvals(benchmark(v))), rtol=1e-9)


def test_a_stiff_waist_comes_near_the_rigid_one() -> None:
    """Ten times the stiffness takes the four roots ten times nearer: the waist gives way by its compliance."""
    rigid = np.linalg.eigvals(benchmark(7.0))
    apart = []
    for stiffness in (1e7, 1e8):
        roots = np.linalg.eigvals(eom.linearise(vehicle("bicycle_rider", U=7.0, k_waist=stiffness)).without_cyclic().A)
        apart.append(max(float(np.min(np.abs(roots - root))) for root in rigid))
    assert apart[0] / apart[1] == pytest.approx(10.0, rel=0.01)


def test_a_free_rider_falls_and_the_waist_of_the_file_holds_him_up() -> None:
    """Without stiffness the fastest growth is a tenth of a second's doubling, as the source says; with it slow."""
    free = roots_of(eom.linearise(vehicle("bicycle_rider", k_waist=0.0, c_waist=0.0)), 6)
    assert np.log(2) / np.max(free.real) == pytest.approx(0.1, rel=0.2)
    held = roots_of(eom.linearise(vehicle("bicycle_rider")), 6)
    assert np.max(held.real) < 1.0
