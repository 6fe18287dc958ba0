"""A steady turn without drive: cornering drag comes out of forces that are turned by steer and articulation."""

import numpy as np
import pytest
from scipy.optimize import fsolve

import eom
from tests.splice.b_train import B_TRAIN
from tests.vehicles.shipped import FOLDER


def b_train(file: str) -> eom.TyreModel:
    """The B-train of a text at 110 km/h, its wheels without resistance."""
    model = eom.build(eom.loads(file, str(FOLDER / "b_train.yaml"), U="110 km/h", f_r=0.0))
    assert isinstance(model, eom.TyreModel)
    return model


def turning(model: eom.TyreModel, steer: float) -> tuple[np.ndarray, np.ndarray]:
    """State and inputs of a steady turn at the speed that a model holds."""
    x, u = model.trim()
    u[model.inputs.index("axle_1.steer")] = steer
    unknown = [k for k in range(3, len(x)) if model.states[k] != "tractor_frame.v_x"]

    def rates(z: np.ndarray) -> np.ndarray:
        """What must vanish."""
        state = x.copy()
        state[unknown] = z
        return model.rhs(0.0, state, u)[unknown]

    found, _, success, message = fsolve(rates, x[unknown], xtol=1e-12, full_output=True)
    assert success == 1, message
    x[unknown] = found
    return x, u


@pytest.mark.parametrize("degrees", [0.5, 1.0])
def test_the_train_decelerates_by_cornering_drag(degrees: float) -> None:
    """At 110 km/h and 1 deg by 0.057 to 0.060 m/s^2: exact planar geometry gives 0.0598, (3.34a) alone 0.032.

    The turn is steady at a held speed, which is then let go: the acceleration is that of the instant. All of it is the
    power that the tyres lose in slip, over mass and speed.
    """
    x, u = turning(b_train(B_TRAIN.replace("trim: {speed: U}", "trim: {speed: U, hold: true}")), np.radians(degrees))
    model = b_train(B_TRAIN)
    drag = -model.rhs(0.0, x, u)[model.states.index("tractor_frame.v_x")]
    assert 0.057 < drag / degrees**2 < 0.060
    y = dict(zip(model.outputs, model.output(0.0, x, u), strict=True))
    lost = sum(y[f"{wheel.name}.Fy"] * np.sin(y[f"{wheel.name}.alpha"]) for wheel in model.prepared.system.wheels)
    # first-order levers, and speeds of the units that differ by 1e-3
    assert -lost / np.sum(model.prepared.model.body.mass) == pytest.approx(drag, rel=0.01)
