"""What the linear model tells about the motion of its bodies, and vehicles with other values of their parameters."""

import numpy as np
import pytest

import eom
from eom.assembly.state_space import output_row
from tests.vehicles.shipped import NAMES, vehicle


@pytest.mark.parametrize("name", NAMES)
def test_a_position_output_is_the_sensor_applied_to_the_motion_of_the_bodies(name: str) -> None:
    assembly = eom.assemble(vehicle(name))
    model = eom.linearise(assembly)
    for k, output in enumerate(assembly.system.outputs):
        if output.quantity == "position":
            seen = output_row(assembly.system, output) @ model.motion
            # the same products in another order
            np.testing.assert_allclose(model.C[k], seen, rtol=0.0, atol=1e-12 * np.max(np.abs(seen), initial=1.0))


@pytest.mark.parametrize("name", NAMES)
def test_the_motion_of_every_state_satisfies_the_joints(name: str) -> None:
    assembly = eom.assemble(vehicle(name))
    moved = assembly.J @ eom.linearise(assembly).motion
    np.testing.assert_allclose(moved, 0.0, atol=1e-10)


def test_other_values_give_the_vehicle_that_loading_with_them_gives() -> None:
    car = vehicle("b_train_yaw_roll")
    heavy: dict[str, str | float] = {"U": "80 km/h", "tractor_frame.mass": 6500.0}
    changed, loaded = car.with_values(**heavy), vehicle("b_train_yaw_roll", **heavy)
    assert changed.system == loaded.system
    assert changed.values == loaded.values
    assert changed.speed == pytest.approx(80.0 / 3.6, rel=1e-15)
    # what was set stays set, the original is left alone
    assert changed.with_values(U="90 km/h").values["tractor_frame.mass"] == 6500.0
    assert car.values["tractor_frame.mass"] == 6308.0


def test_other_values_are_checked_as_those_of_a_file() -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        vehicle("b_train_yaw_roll").with_values(U="300 km/h", speed=3.0)
    assert "cannot set 'U': it is 83.3333, but at most 44.4444 is allowed" in str(caught.value)
    assert "cannot set 'speed'" in str(caught.value)
