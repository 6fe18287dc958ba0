"""The B-train with wheels beside Appendix C of Zhu's thesis, and what each difference does to its roots."""

import numpy as np
import pytest

import eom
from eom.closed_form import b_train_yaw_roll
from tests.closed_form.same_vehicle import SETS, yaw_roll, yaw_roll_values
from tests.splice.b_train import B_TRAIN, own_weight, without_spins
from tests.vehicles.shipped import FOLDER

U = 110 / 3.6


def roots(text: str, **values: float | str) -> np.ndarray:
    """Roots of a B-train's linear model that are not zero."""
    model = eom.linearise(eom.loads(text, str(FOLDER / "b_train.yaml"), **values))
    found = np.asarray(model.modes().eigenvalues)
    return np.asarray(found[np.abs(found) > 1e-6])


def distances(found: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Relative distance of each wanted root from the nearest one found."""
    return np.asarray(np.min(np.abs(found[:, np.newaxis] - wanted) / np.abs(wanted), axis=0))


@pytest.mark.parametrize("number", SETS)
def test_lateral_and_roll_roots_are_those_of_appendix_c_where_units_carry_their_own_weight(number: int) -> None:
    """Without resistance and spins; law 3 holds to 1e-10, and the condition of these roots stays below 100."""
    p = yaw_roll(number)
    values = {
        name.replace("tridem_suspension", "suspension"): value / 2 if name.endswith(".cornering") else value
        for name, value in yaw_roll_values(p).items()
        if not name.endswith("_ride.at.x")
    }
    for i, x in ((1, p.l_c21), (2, p.l_c3)):
        values |= {f"semitrailer_{i}_tridem.support.at.x": -x, f"semitrailer_{i}_level.at.x": -x}
    found = roots(without_spins(own_weight(B_TRAIN)), U=U, f_r=0.0, **values)
    wanted = np.linalg.eigvals(b_train_yaw_roll.state_space(p, U, "full").A)
    wanted = wanted[np.abs(wanted) > 1e-6]
    assert len(found) == len(wanted) == 18
    assert np.max(distances(found, wanted)) < 1e-8
