"""Published results: the Whipple bicycle, the rolling disc, the quarter car.

The bicycle is the benchmark of J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Linearized dynamics
equations for the balance and steer of a bicycle: a benchmark and review, Proc. R. Soc. A 463 (2007) 1955-1982. Its
roots are printed to 14 digits in Table 2, and so are the coefficients of the two equations for lean and steer:

    M q'' + v C1 q' + (g K0 + v^2 K2) q = 0

Tolerance: the printed digits, 1e-10 relative to the largest root at a speed. The kernel starts from four bodies in
24 coordinates and not from these equations; rounding costs it about 1e-12.
"""

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from eom.vehicle.load import load
from tests.assembly.systems import Complex, linear, model_with, pivots_of, transfer

VEHICLES = Path(__file__).parents[2] / "vehicles"
GRAVITY = 9.81
MASS = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
DAMPING = np.array([[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])
STIFFNESS_0 = np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
STIFFNESS_2 = np.array([[0.0, 76.59734589573222], [0.0, 2.65431523794604]])

PRINTED: dict[int, list[complex]] = {
    0: [3.13164324790656, -3.13164324790656, 5.53094371765393, -5.53094371765393],
    1: [
        3.52696170990070 + 0.80774027519930j,
        3.52696170990070 - 0.80774027519930j,
        -3.13423125066578,
        -7.11008014637442,
    ],
    5: [
        -0.77534188219585 + 4.46486771378823j,
        -0.77534188219585 - 4.46486771378823j,
        -0.32286642900409,
        -14.07838969279822,
    ],
}
"""Table 2, a few of its lines."""


def own_roots(name: str, U: float) -> Complex:
    """Roots of a shipped vehicle at a speed, sorted, without those of its cyclic coordinates."""
    found = linear(load(VEHICLES / name, U=U).system)
    A = found.model.A
    kept = np.setdiff1d(np.arange(len(A)), found.pivots.cyclic)
    return np.sort_complex(np.linalg.eigvals(A[np.ix_(kept, kept)]).astype(np.complex128))


def bicycle_roots(U: float) -> Complex:
    """The four roots of lean and steer: the largest, as zero speed leaves further zeros (wheels free to stand)."""
    roots = own_roots("bicycle.yaml", U)
    four = roots[np.argsort(-np.abs(roots))][:4]
    np.testing.assert_allclose(np.setdiff1d(roots, four), 0.0, atol=1e-6)
    return np.sort_complex(four)


def benchmark_roots(U: float) -> Complex:
    """Roots of the published two equations."""
    stiffness = GRAVITY * STIFFNESS_0 + U**2 * STIFFNESS_2
    lower = -np.linalg.solve(MASS, np.hstack([stiffness, U * DAMPING]))
    A = np.vstack([np.hstack([np.zeros((2, 2)), np.eye(2)]), lower])
    return np.sort_complex(np.linalg.eigvals(A).astype(np.complex128))


def assert_same_roots(found: Complex, expected: Complex) -> None:
    """Root by root, each expected one once, to 1e-10 of the largest."""
    assert found.shape == expected.shape
    limit = 1e-10 * float(np.max(np.abs(expected)))
    left = list(found)
    for root in expected:
        nearest = min(left, key=lambda other: abs(other - root))
        left.remove(nearest)
        assert abs(nearest - root) <= limit


@pytest.mark.parametrize("U", PRINTED)
def test_bicycle_has_the_printed_roots(U: int) -> None:
    assert_same_roots(bicycle_roots(float(U)), np.array(PRINTED[U], dtype=np.complex128))


@pytest.mark.parametrize("U", range(11))
def test_bicycle_has_the_roots_of_the_published_equations(U: int) -> None:
    assert_same_roots(bicycle_roots(float(U)), benchmark_roots(float(U)))


def test_bicycle_weave_becomes_stable_at_the_published_speed() -> None:
    """The real part of the complex pair crosses zero; its slope there is 0.6 per m/s: ten digits are well defined."""

    def weave(U: float) -> float:
        roots = bicycle_roots(U)
        return float(np.max(roots[np.abs(roots.imag) > 0.1].real))

    assert brentq(weave, 4.0, 5.0, xtol=1e-12) == pytest.approx(4.29238253634111, abs=5e-11)


def test_bicycle_capsize_becomes_unstable_at_the_published_speed() -> None:
    def capsize(U: float) -> float:
        roots = bicycle_roots(U)
        return float(np.max(roots[np.abs(roots.imag) < 1e-9].real))

    assert brentq(capsize, 5.5, 7.0, xtol=1e-12) == pytest.approx(6.02426201538837, abs=5e-11)


def lean_and_steer(U: float, s: complex) -> tuple[Complex, Complex]:
    """Answer of lean and steer to steer torque and lean torque at *s*: found, and by the published equations.

    Only steer and its torque change sign with the axes: the benchmark's steering axis points down, and so does
    its z. Lean is about the same axis forward.
    """
    system = load(VEHICLES / "bicycle.yaml", U=U).system
    found = transfer(linear(system).model, s)[:2]
    dynamic = MASS * s**2 + U * DAMPING * s + GRAVITY * STIFFNESS_0 + U**2 * STIFFNESS_2
    compliance = np.linalg.inv(dynamic)
    sign = np.array([1.0, -1.0])
    published = sign[:, np.newaxis] * compliance * sign
    return found, published[:, ::-1]


@pytest.mark.parametrize("s", [0.5j, 3.0j, 1.0 + 10.0j])
def test_bicycle_answers_steer_and_lean_torque_as_published(s: complex) -> None:
    """Inputs in the file's order: steer torque between fork and frame, lean torque on the frame."""
    found, published = lean_and_steer(5.0, s)
    np.testing.assert_allclose(found, published, rtol=1e-9)


def test_bicycle_pivots_chosen_at_one_speed_serve_all_others() -> None:
    """The choice of coordinates is made once for a structure; a speed is but a number."""
    system = load(VEHICLES / "bicycle.yaml", U=5.0).system
    pivots = pivots_of(system)
    for U in (0.01, 1.0, 10.0, 40.0):
        other = load(VEHICLES / "bicycle.yaml", U=U).system
        A = model_with(other, pivots).A
        kept = np.setdiff1d(np.arange(len(A)), pivots.cyclic)
        assert_same_roots(np.linalg.eigvals(A[np.ix_(kept, kept)]).astype(np.complex128), benchmark_roots(U))


def test_bicycle_pivots_chosen_at_speed_serve_standstill() -> None:
    """Wheels that do not spin have no spin axis, and yet the coordinates that were chosen keep their meaning."""
    system = load(VEHICLES / "bicycle.yaml", U=5.0).system
    pivots = pivots_of(system)
    still = load(VEHICLES / "bicycle.yaml", U=0.0).system
    A = model_with(still, pivots).A
    kept = np.setdiff1d(np.arange(len(A)), pivots.cyclic)
    assert_same_roots(np.linalg.eigvals(A[np.ix_(kept, kept)]).astype(np.complex128), benchmark_roots(0.0))


@pytest.mark.parametrize("r", [0.1, 0.3, 2.0])
def test_disc_becomes_stable_at_the_square_root_of_g_r_over_3(r: float) -> None:
    """The square of its roots, 4 g / 5 r - 12 U^2 / 5 r^2 for a thin disc, changes sign there.

    Rounding moves the square by 1e-15 of its terms, and so the speed: 1e-9 is well within reach.
    """

    def square(U: float) -> float:
        found = linear(load(VEHICLES / "disc.yaml", U=U, r=r).system)
        kept = np.setdiff1d(np.arange(len(found.model.A)), found.pivots.cyclic)
        A = found.model.A[np.ix_(kept, kept)]
        # roots s, -s and zeros: the trace of A^2 is 2 s^2
        return float(np.trace(A @ A)) / 2.0

    critical = np.sqrt(GRAVITY * r / 3.0)
    assert square(2.0 * critical) == pytest.approx(0.8 * GRAVITY / r - 2.4 * 4.0 * critical**2 / r**2, rel=1e-9)
    assert brentq(square, 0.5 * critical, 2.0 * critical, xtol=1e-13) == pytest.approx(critical, rel=1e-9)


def test_quarter_car_has_the_transfer_functions_of_the_textbooks() -> None:
    """Sprung acceleration, suspension travel and tyre deflection per road, between 0.1 and 30 Hz."""
    m_s, m_u, k_s, c_s, k_t, c_t = 300.0, 40.0, 20e3, 1500.0, 200e3, 50.0
    model = linear(load(VEHICLES / "quarter_car.yaml").system).model
    for frequency in (0.1, 1.2, 10.0, 30.0):
        s = 2j * np.pi * frequency
        suspension, tyre = k_s + c_s * s, k_t + c_t * s
        sprung = m_s * s**2 + suspension
        bottom = sprung * (m_u * s**2 + suspension + tyre) - suspension**2
        z_s, z_u = tyre * suspension / bottom, tyre * sprung / bottom
        np.testing.assert_allclose(transfer(model, s)[:, 0], [s**2 * z_s, z_s - z_u, z_u - 1.0], rtol=1e-9)
