"""CommonRoad's tyre formulas as a second opinion.

M. Althoff and G. Wuersching, CommonRoad: Vehicle Models, TU Munich, 2020. They are PAC2002 with all scales 1, no terms
in load and the cornering stiffness PKY1 Fz. Three of their lines are known to be wrong and kept out of the way: the
lateral shifts change sign with camber and vanish without it (so camber is positive here), and the longitudinal function
turns the sign of kappa (turned back here) and adds SVx inside the sine (zero here).
"""

from types import SimpleNamespace

from vehiclemodels.utils import tire_model

from tests.tyre.plain_sets import as_61
from tests.tyre.random_sets import NAMES_52, SCALES_52, random_set_52, random_states
from tests.tyre.referee_mf import tool_61
from tests.tyre.referee_mf52 import tool_52

NAMES = (
    *("p_cx1", "p_dx1", "p_dx3", "p_ex1", "p_kx1", "p_hx1", "r_bx1", "r_bx2", "r_cx1", "r_ex1", "r_hx1"),
    *("p_cy1", "p_dy1", "p_dy3", "p_ey1", "p_ky1", "p_hy1", "p_hy3", "p_vy1", "p_vy3"),
    *("r_by1", "r_by2", "r_by3", "r_cy1", "r_ey1", "r_hy1", "r_vy1", "r_vy3", "r_vy4", "r_vy5", "r_vy6"),
)
OURS = {name: name.replace("_", "").upper() for name in NAMES}


def simplified(seed: int, Fz: float) -> dict[str, float]:
    """A 5.2 set with CommonRoad's coefficients only, its nominal load the load and its stiffness largest there."""
    full = random_set_52(seed)
    kept = {name: float(name in SCALES_52) for name in NAMES_52} | {name: full[name] for name in OURS.values()}
    return kept | {"UNLOADED_RADIUS": 0.3, "LONGVL": 16.7, "FNOMIN": Fz, "PKY2": 1.0}


def test_forces_in_the_plane_agree_with_commonroad() -> None:
    for seed in range(20):
        for any_state in random_states(seed, 4000.0, 20):
            state = any_state._replace(gamma=abs(any_state.gamma))
            alpha, kappa, Fz, gamma, _ = state
            ours = simplified(seed, Fz)
            theirs = SimpleNamespace(**{name: ours[own] for name, own in OURS.items()}, p_vx1=0.0)
            pure_x = tire_model.formula_longitudinal(-kappa, gamma, Fz, theirs)
            pure_y, mu = tire_model.formula_lateral(alpha, gamma, Fz, theirs)
            Fx = tire_model.formula_longitudinal_comb(kappa, alpha, pure_x, theirs)
            Fy = tire_model.formula_lateral_comb(kappa, alpha, gamma, mu, Fz, pure_y, theirs)
            for found in (tool_52(ours, *state), tool_61(as_61(ours, Fz), *state)):
                # Some tens of operations on numbers of the size of the load.
                assert abs(found[0] - Fx) < 1e-13 * Fz
                assert abs(found[1] - Fy) < 1e-13 * Fz
