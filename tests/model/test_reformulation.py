"""The tyres taken out of the damping matrix: thesis (3.46) and (3.47), done by the generator and by its recipe."""

import re

import numpy as np
import pytest

import eom
from tests.splice.b_train import B_TRAIN, linear_tyres
from tests.splice.shared import SIMPLE
from tests.vehicles.shipped import FOLDER, WHEELED, text, vehicle

NAMES = SIMPLE + WHEELED
SPEEDS = (5, 60, 88, 110, 120)
UNITY = r"(cornering|longitudinal): [\d.]+ (?:kN|N)(/rad)?"


def recipe(file: str) -> str:
    """The thesis's own way: every stiffness set to one in the file."""
    changed = re.sub(UNITY, lambda found: f"{found[1]}: 1 N{found[2] or ''}", file)
    assert changed != file
    return changed


@pytest.mark.parametrize(
    "file",
    [text("b_train_yaw_roll"), linear_tyres(B_TRAIN).replace("trim: {speed: U}", "trim: {speed: U, hold: true}")],
    ids=["lateral", "with wheels"],
)
def test_stiffnesses_of_one_in_the_file_give_c_unity(file: str) -> None:
    """Its damping matrix is C_unity of the file as it is, and its Theta what the rows alone give; to rounding.

    Without rolling resistance, which needs stiffness to be balanced.
    """
    values = {"f_r": 0.0} if "f_r" in file else {}
    where = str(FOLDER / "b_train.yaml")
    own, unity = (eom.loads(item, where, **values) for item in (file, recipe(file)))
    taken, again = eom.reformulate(own), eom.reformulate(unity)
    C = eom.assemble(unity).C
    np.testing.assert_allclose(taken.C_unity, C, rtol=1e-12, atol=1e-12 * np.max(np.abs(C)))
    np.testing.assert_allclose(again.C_unity, C, rtol=1e-12, atol=1e-12 * np.max(np.abs(C)))
    np.testing.assert_allclose(again.Theta, C - taken.C_rest, atol=1e-12 * np.max(np.abs(C)))


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("name", NAMES)
def test_theta_put_back_gives_the_linear_equations(name: str, speed: int) -> None:
    """Law 1 in the thesis's form: (A1 + A2 diag(0, Theta)) R is the matrix of the whole.

    To 1e-12 of what is added up in its rows, before they are divided by the masses.
    """
    assembly = eom.assemble(vehicle(name, U=f"{speed} km/h"))
    taken, whole = eom.reformulate(assembly), assembly.descriptor
    N, L = len(assembly.M), assembly.L.T
    zero, one = np.zeros((N, N)), np.eye(N)
    without = np.block([[assembly.V, -one], [assembly.K, taken.C_rest]])
    tyres = np.block([[zero, zero], [zero, taken.Theta]])
    size = np.max(np.abs(L) @ (np.abs(without) + np.abs(tyres)) @ np.abs(taken.R), axis=1, keepdims=True)
    assert np.all(np.abs(L @ (without + tyres) @ taken.R + whole.A) <= 1e-12 * size)
    # (3.47); masses, their rows of one size, have a condition up to some 1e3: rounding of 1e-16 times that
    for found, wanted, added in ((taken.A2, -L, np.abs(L)), (taken.A1, -L @ without, np.abs(L) @ np.abs(without))):
        size = np.max(np.abs(whole.E) @ np.abs(found) + added, axis=1, keepdims=True)
        assert np.all(np.abs(whole.E @ found - wanted) <= 1e-13 * size)


@pytest.mark.parametrize("name", NAMES)
def test_forces_on_the_rows_do_the_work_of_their_slip(name: str) -> None:
    """Power conjugate: forces on w by rows H are H' f, whose power on any w is that of f on the slip velocities."""
    taken = eom.reformulate(vehicle(name))
    rng = np.random.default_rng(1)
    w, f = rng.normal(size=taken.H.shape[1]), rng.normal(size=len(taken.rows))
    assert w @ (taken.H.T @ f) == pytest.approx((taken.H @ w) @ f, rel=1e-12)
    np.testing.assert_allclose(w @ taken.Theta @ w, (taken.H @ w) @ taken.coefficients @ (taken.H @ w), rtol=1e-10)
    assert len(taken.rows) == len(taken.H) == len(taken.coefficients)


def test_every_wheel_has_a_lateral_row_and_one_with_a_spin_a_longitudinal_one() -> None:
    rows = eom.reformulate(vehicle("b_train")).rows
    assert len(rows) == 36
    assert rows[:2] == ("axle_1.left.lateral", "axle_1.left.longitudinal")


def test_a_vehicle_without_axles_is_refused() -> None:
    with pytest.raises(eom.DescriptionError, match="no axles with tyres"):
        eom.reformulate(vehicle("quarter_car"))
