"""What the nonlinear equations do not know is refused by name, with what to do."""

from collections.abc import Callable

import pytest

import eom
from tests.splice.b_train import B_TRAIN
from tests.vehicles.shipped import FOLDER, text


def refused(file: str) -> str:
    """The message with which a file is refused."""
    with pytest.raises(eom.EomError) as caught:
        eom.build(eom.loads(file, str(FOLDER / "b_train.yaml")))
    return str(caught.value)


def with_section(section: str) -> Callable[[str], str]:
    """Adds top-level lines to a file."""
    return lambda file: f"{file}\n{section}\n"


def connector(line: str) -> Callable[[str], str]:
    """Adds a connector to the whole."""
    return with_section(f"connectors:\n  odd: {line}")


def load(line: str) -> Callable[[str], str]:
    """Adds a load to the whole."""
    return with_section(f"loads:\n  odd: {line}")


PLACE = "[-1.384, 0, 1.019]"
TO_GROUND = f"type: flex_point, between: [tractor_frame, ground], at: {PLACE}, forces: 1"
HELD = "type: rigid_point, between: [semitrailer_2_frame, ground], at: [-24, 0, 1], moments: 1, axis: [0, 0, 1]"
CASES: dict[str, tuple[Callable[[str], str], str]] = {
    "a lateral spring to the ground": (
        connector(f"{{{TO_GROUND}, axis: [0, 1, 0], stiffness: 1e5}}"),
        "connectors.odd: acts on place or heading of the whole",
    ),
    "a damper along the road to the ground": (
        connector(f"{{{TO_GROUND}, axis: [1, 0, 0], damping: 100}}"),
        "connectors.odd: acts on place or heading of the whole",
    ),
    "a heading that is held": (
        connector(f"{{{HELD}}}"),
        "not free along x, along y and in yaw|acts on place or heading",
    ),
    "a load along a direction of the ground": (
        load(f"{{body: tractor_frame, at: {PLACE}, force: [-1000, 0, 0]}}"),
        "loads.odd: pulls along a direction of the ground.*'frame'",
    ),
    "a side load that nothing balances": (
        load(f"{{body: tractor_frame, at: {PLACE}, force: [0, 5000, 0], frame: tractor_frame}}"),
        "not in equilibrium in the straight run",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_a_free_heading_does_not_know_is_refused(name: str) -> None:
    change, sentence = CASES[name]
    with pytest.raises(eom.EomError, match=sentence):
        eom.build(eom.loads(change(B_TRAIN), str(FOLDER / "b_train.yaml")))


def test_supports_that_share_a_load_in_any_proportion_are_refused() -> None:
    """Three axle groups on one rigid unit: statics cannot tell them apart."""
    group, axle = "mid: {body: frame, support: {at: [-2, 0, 0]}}", "mid: {group: mid, x: -2, tyre: rear}"
    file = text("tractor_semitrailer_nonlinear").replace(
        "    axles:\n", f"      {group}\n    axles:\n      {axle}\n", 1
    )
    assert "shares its load with other joints in any proportion" in refused(file)


def test_a_tyre_file_for_one_side_needs_a_track() -> None:
    law = "nonlinear: &law {kind: magic_formula, friction: mu, C_x: 1.65, E_x: 0, C_y: 1.3, E_y: -1}"
    file = B_TRAIN.replace(
        f"    rolling_resistance: f_r\n    {law}", "    nonlinear: {kind: tir, file: tyres/passenger_car.tir}"
    )
    file = file.replace(", track: 1.98 m", "").replace(
        "nonlinear: *law", "nonlinear: {kind: magic_formula, friction: mu}"
    )
    assert "tyre file, which is for one side" in refused(file)


def test_all_findings_are_told_at_once() -> None:
    loads = "".join(
        f"  {name}: {{body: tractor_frame, at: {PLACE}, force: {force}}}\n"
        for name, force in (("a", "[1, 0, 0]"), ("b", "[0, 1, 0]"))
    )
    message = refused(f"{B_TRAIN}\nloads:\n{loads}")
    assert "loads.a" in message
    assert "loads.b" in message
