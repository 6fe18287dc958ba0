"""A run knows its signals by name, and says so where it does not."""

from dataclasses import replace

import numpy as np
import pytest

from eom.errors import AnalysisError, SimulationError
from eom.simulation.run import Channels, Run
from tests.simulation.recorded import event, small_run


def test_each_name_gives_its_own_column() -> None:
    run = small_run()
    for group, before in ((run.inputs, ""), (run.outputs, ""), (run.blocks, ""), (run.states, "state:")):
        for k, name in enumerate(group.names):
            np.testing.assert_array_equal(run.of(before + name), group.values[:, k])


def test_names_are_those_that_a_run_is_asked_for() -> None:
    run = small_run()
    assert len(run.names) == len(set(run.names)) == 1 + 3 + 1 + 3
    assert all(run.of(name).shape == run.time.shape for name in run.names)


@pytest.mark.parametrize(
    ("asked", "meant"),
    [
        ("tractor.az", "tractor.ay"),
        ("axle1.steer", "axle_1.steer"),
        ("gyro.mesured", "gyro.measured"),
        ("state:tractor_frame.vx", "state:tractor_frame.v_x"),
        ("tractor_frame.v_x", "state:tractor_frame.v_x"),
    ],
)
def test_an_unknown_name_is_answered_with_the_one_that_was_meant(asked: str, meant: str) -> None:
    run = small_run()
    with pytest.raises(AnalysisError, match=rf"^signal {asked}: there is no such signal; did you mean .*'{meant}'\?$"):
        run.of(asked)


def test_an_output_goes_before_a_state_of_the_same_name() -> None:
    run = small_run()
    assert not np.array_equal(run.of("tractor_frame.roll"), run.of("state:tractor_frame.roll"))


def test_a_run_that_does_not_fit_together_is_refused_with_every_mistake() -> None:
    run = small_run()
    states = Channels(("a", "b"), ("m",), ("", ""), np.zeros((4, 2)))
    with pytest.raises(SimulationError) as caught:
        replace(run, states=states, blocks=run.inputs)
    assert str(caught.value).splitlines() == [
        "states: 2 names, but 1 units",
        f"states: expected values of shape ({len(run.time)}, 2), samples by signals, got (4, 2)",
        "signal axle_1.steer: 2 signals of the run have this name, expected one",
    ]


def test_a_run_has_a_sample() -> None:
    def none(group: Channels) -> Channels:
        return group._replace(values=group.values[:0])

    run = small_run()
    with pytest.raises(SimulationError, match=r"^time: expected samples, got none$"):
        replace(
            run,
            time=run.time[:0],
            inputs=none(run.inputs),
            states=none(run.states),
            outputs=none(run.outputs),
            blocks=none(run.blocks),
        )


def test_a_run_may_have_no_blocks() -> None:
    assert "gyro.measured" not in small_run(blocks=()).names


def test_an_event_reads_as_a_sentence() -> None:
    assert (
        str(event("lift", "axle_7.left", 2.34, 2.68)) == "2.34 s: axle_7.left: it does what it must not (until 2.68 s)"
    )
    assert str(event("jackknife", "dolly", 0.5)) == "0.5 s: dolly: it does what it must not"


def test_the_data_set_has_every_signal_with_its_unit_and_meaning() -> None:
    run = small_run()
    data = run.data()
    assert set(data.data_vars) == {*run.inputs.names, *run.outputs.names, *run.blocks.names, "states"}
    np.testing.assert_array_equal(data["time"], run.time)
    for group in (run.inputs, run.outputs, run.blocks):
        for name, unit, description in zip(group.names, group.units, group.descriptions, strict=True):
            np.testing.assert_array_equal(data[name], run.of(name))
            assert data[name].dims == ("time",)
            assert data[name].attrs == {"units": unit, "long_name": description or name}


def test_states_of_the_data_set_are_found_by_name() -> None:
    run = small_run()
    states = run.data()["states"]
    assert states.dims == ("time", "state")
    for name, unit in zip(run.states.names, run.states.units, strict=True):
        one = states.sel(state=name)
        np.testing.assert_array_equal(one, run.of(f"state:{name}"))
        assert one["state_unit"].item() == unit


def test_the_data_set_tells_where_the_run_came_from_and_what_happened() -> None:
    run = small_run(events=(event("lift", "axle_1.left", 1.0), event("lock", "axle_1.right", 2.0, 3.0)))
    about = run.data().attrs
    assert {key: about[key] for key in run.identity} == run.identity
    assert (about["name"], about["method"], about["ended"]) == (run.name, run.method, run.ended)
    assert about["events"].splitlines() == [str(item) for item in run.events]


def test_names_that_the_data_set_needs_are_refused_all_at_once() -> None:
    run = small_run(outputs=("time", "tractor.ay", "states"))
    with pytest.raises(AnalysisError) as caught:
        run.data()
    assert [line.split(":")[0] for line in str(caught.value).splitlines()] == ["signal time", "signal states"]
    assert run.of("time").shape == run.time.shape


def test_asking_changes_nothing() -> None:
    run, same = small_run(), small_run()
    run.data()["tractor.ay"].copy()
    run.plot()
    for name in run.names:
        np.testing.assert_array_equal(run.of(name), same.of(name))
    assert isinstance(run, Run)
