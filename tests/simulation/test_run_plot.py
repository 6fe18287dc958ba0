"""The picture of a run shows what there is, and only that."""

from dataclasses import replace
from io import BytesIO
from typing import Any

import numpy as np
import pytest

import eom
from eom.errors import AnalysisError
from eom.simulation.run import Channels, Run
from tests.simulation.recorded import VEHICLES, b_train_run, channels, event, small_run, without

PANELS = {
    "steer [deg]": ("axle_1.steer",),
    "lateral acceleration [m/s²]": ("tractor", "semitrailer_1", "semitrailer_2"),
    "yaw rate [deg/s]": ("tractor", "semitrailer_1", "semitrailer_2"),
    "articulation [deg]": ("semitrailer_1", "semitrailer_2"),
    "roll [deg]": tuple(
        f"{unit}_{body}" for unit in ("tractor", "semitrailer_1", "semitrailer_2") for body in ("frame", "axles")
    ),
    "wheel load [kN]\nright dashed": (
        "axle_1",
        "axle_2, axle_3",
        "axle_4, axle_5, axle_6",
        "axle_7, axle_8, axle_9",
    ),
}


def shown(figure: Any) -> dict[str, tuple[str, ...]]:
    """Labels of the curves of each panel."""
    return {axes.get_ylabel(): tuple(text.get_text() for text in axes.get_legend().get_texts()) for axes in figure.axes}


def panel(figure: Any, label: str) -> Any:
    """The panel whose label starts so."""
    return next(axes for axes in figure.axes if axes.get_ylabel().startswith(label))


def test_a_train_shows_what_one_looks_at_first() -> None:
    found = shown(b_train_run().plot())
    assert {key: found[key] for key in PANELS} == PANELS
    assert list(found) == [*PANELS, "speed [m/s]"]


@pytest.mark.parametrize(
    ("endings", "gone"),
    [
        (("ay",), "lateral acceleration [m/s²]"),
        (("articulation",), "articulation [deg]"),
        (("yaw_rate",), "yaw rate [deg/s]"),
        (("roll",), "roll [deg]"),
        (("Fz", "ltr"), "wheel load [kN]\nright dashed"),
        (("speed",), "speed [m/s]"),
    ],
)
def test_what_a_run_has_not_is_not_shown(endings: tuple[str, ...], gone: str) -> None:
    run = b_train_run()
    whole = shown(run.plot())
    found = shown(replace(run, outputs=without(run.outputs, *endings)).plot())
    assert found == {key: value for key, value in whole.items() if key != gone}


def test_without_loads_of_two_sides_load_transfer_ratios_are_shown() -> None:
    run = b_train_run()
    found = shown(replace(run, outputs=without(run.outputs, "Fz")).plot())
    assert found["load transfer ratio [-]"] == ("tractor", "semitrailer_1", "semitrailer_2")


def test_curves_are_the_signals_in_the_unit_told() -> None:
    run = b_train_run()
    figure = run.plot()
    for label, name, factor in (
        ("yaw rate", "semitrailer_1.yaw_rate", 180.0 / np.pi),
        ("lateral acceleration", "semitrailer_1.ay", 1.0),
        ("wheel load", "axle_1.right.Fz", 1e-3),
    ):
        line = panel(figure, label).lines[1]
        np.testing.assert_array_equal(line.get_xdata(), run.time)
        np.testing.assert_allclose(line.get_ydata(), factor * run.of(name), rtol=1e-14)


def test_right_wheels_are_dashed_and_have_the_colour_of_the_left_ones() -> None:
    lines = panel(b_train_run().plot(), "wheel load").lines
    for left, right in zip(lines[::2], lines[1::2], strict=True):
        assert (left.get_linestyle(), right.get_linestyle()) == ("-", "--")
        assert left.get_color() == right.get_color()


def test_a_unit_has_one_colour_in_every_panel() -> None:
    colours: dict[str, set[str]] = {"tractor": set(), "semitrailer_1": set(), "semitrailer_2": set()}
    for axes in b_train_run().plot().axes:
        for line in axes.lines:
            unit = str(line.get_label()).removesuffix("_frame").removesuffix("_axles")
            if unit in colours:
                colours[unit].add(str(line.get_color()))
    assert sorted(map(sorted, colours.values())) == [["C0"], ["C1"], ["C2"]]


def test_an_axle_that_carries_otherwise_is_drawn_apart() -> None:
    run = b_train_run()
    values = run.outputs.values.copy()
    values[40:, run.outputs.names.index("axle_8.left.Fz")] += 2000.0
    found = shown(replace(run, outputs=run.outputs._replace(values=values)).plot())
    assert found["wheel load [kN]\nright dashed"][-2:] == ("axle_7, axle_9", "axle_8")


def test_many_curves_that_are_one_are_counted() -> None:
    run = b_train_run()
    brakes = [k for k, name in enumerate(run.inputs.names) if name.endswith("brake_pressure")]
    values = run.inputs.values.copy()
    values[20:, brakes] = 2e5
    found = shown(replace(run, inputs=run.inputs._replace(values=values)).plot())
    assert found["brake pressure [kPa]"] == ("axle_1.left.brake_pressure and 17 alike",)


def test_inputs_that_stay_are_shown_only_if_none_changes() -> None:
    run = b_train_run()
    assert "drive torque [N·m]" not in shown(run.plot())
    steady = run.inputs._replace(values=np.tile(run.inputs.values[0], (len(run.time), 1)))
    found = shown(replace(run, inputs=steady).plot())
    assert (found.get("drive torque [N·m]"), "steer [deg]" in found) == (("drive_torque",), False)


def test_a_suspension_shows_all_its_sensors_by_unit_of_measure() -> None:
    model = eom.linearise(eom.load(VEHICLES / "full_car.yaml"))
    rng = np.random.default_rng(1)

    def made(names: tuple[str, ...], units: tuple[str, ...]) -> Channels:
        return channels(dict(zip(names, units, strict=True)), rng.standard_normal((30, len(names))))

    run = replace(
        small_run(blocks=(), samples=30),
        inputs=made(model.inputs, model.input_units),
        states=made(model.states, model.state_units),
        outputs=made(model.outputs, model.output_units),
    )
    told = [name for labels in shown(run.plot()).values() for name in labels]
    assert sorted(told) == sorted((*model.inputs, *model.outputs))


def test_named_signals_are_shown_by_unit_of_measure_and_nothing_else() -> None:
    run = b_train_run()
    names = ["tractor.ay", "state:tractor_frame.roll", "semitrailer_2.ay", "tractor.yaw", "fifth_wheel_1.Fx"]
    assert shown(run.plot(names)) == {
        "ay [m/s²]": ("tractor.ay", "semitrailer_2.ay"),
        "[deg]": ("state:tractor_frame.roll", "tractor.yaw"),
        "Fx [N]": ("fifth_wheel_1.Fx",),
    }


def test_names_that_a_run_has_not_are_refused_all_at_once() -> None:
    with pytest.raises(AnalysisError) as caught:
        b_train_run().plot(["tractor.ay", "tractor.az", "axle_1.left.fz"])
    first, second = str(caught.value).splitlines()
    assert first == "signal tractor.az: there is no such signal; did you mean 'tractor.ay'?"
    assert second == "signal axle_1.left.fz: there is no such signal; did you mean 'axle_1.left.Fz'?"
    with pytest.raises(AnalysisError, match="no signal to plot"):
        b_train_run().plot([])


def marks(axes: Any) -> list[float]:
    """Where a panel has lines from top to bottom."""
    return [float(line.get_xdata()[0]) for line in axes.lines if list(line.get_ydata()) == [0, 1]]


def test_each_event_is_a_line_in_every_panel_and_told_below() -> None:
    events = (
        event("rollover", "semitrailer_2", 2.5),
        event("lift", "axle_7.left", 1.2, 1.5),
        event("lift", "axle_8.left", 1.2, 1.5),
    )
    figure = replace(b_train_run(), events=events).plot()
    assert all(marks(axes) == [1.2, 2.5] for axes in figure.axes)
    assert [[text.get_text() for text in axes.texts] for axes in figure.axes[:2]] == [["1", "2"]] * 2
    assert figure.get_supxlabel().splitlines() == [
        "1   1.20 s   lift until 1.50 s: axle_7.left, axle_8.left",
        "2   2.50 s   rollover: semitrailer_2",
    ]


def test_of_very_many_events_all_are_lines_and_the_first_are_told() -> None:
    events = tuple(event("lift", "axle_7.left", 0.1 * k, 0.1 * k + 0.05) for k in range(30))
    figure = replace(b_train_run(), events=events).plot(["tractor.ay"])
    assert len(marks(figure.axes[0])) == 30
    lines = figure.get_supxlabel().splitlines()
    assert (len(lines), lines[-1]) == (13, "and 18 more, as lines without a number")


def test_the_title_is_the_vehicle_and_why_it_ended_early() -> None:
    run = b_train_run()
    assert run.plot().get_suptitle() == run.name
    early = replace(run, ended="it ended at 4 s of 8 s: semitrailer_2 rolled over")
    assert early.plot().get_suptitle().splitlines() == [run.name, early.ended]


def test_without_events_there_is_no_line_and_no_text() -> None:
    figure = b_train_run().plot()
    assert not any(marks(axes) for axes in figure.axes)
    assert figure.get_supxlabel() == ""


def first(run: Run, samples: int) -> Run:
    """The run until then."""
    parts = {key: getattr(run, key) for key in ("inputs", "states", "outputs", "blocks")}
    cut = {key: group._replace(values=group.values[:samples]) for key, group in parts.items()}
    return replace(run, time=run.time[:samples], **cut)


def test_a_long_run_of_many_curves_is_drawn_without_looking_for_a_place() -> None:
    run = b_train_run()
    values = np.tile(run.inputs.values, (3000, 1))
    values += np.random.default_rng(2).random(values.shape)
    long = replace(
        run,
        time=np.linspace(0.0, 60.0, len(values)),
        inputs=run.inputs._replace(values=values),
        states=run.states._replace(values=np.tile(run.states.values, (3000, 1))),
        outputs=without(run.outputs, "")._replace(values=np.zeros((len(values), 0))),
        blocks=run.blocks._replace(values=np.zeros((len(values), 0))),
    )
    figure = long.plot()
    figure.savefig(BytesIO(), format="png", dpi=20)
    assert len(shown(figure)["brake pressure [Pa]"]) == 18


def test_a_single_sample_and_values_that_are_no_numbers_can_be_drawn() -> None:
    run = b_train_run()
    values = run.outputs.values.copy()
    values[-1] = np.nan
    values[-2] = np.inf
    for odd in (first(run, 1), replace(run, outputs=run.outputs._replace(values=values))):
        odd.plot().savefig(BytesIO(), format="png", dpi=20)
        odd.plot(["tractor.ay"]).savefig(BytesIO(), format="png", dpi=20)
