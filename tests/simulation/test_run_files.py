"""What a run writes is what is read back, to the last bit."""

from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from eom.assembly.vectors import Array
from eom.errors import AnalysisError
from eom.simulation import files
from eom.simulation.run import Channels, Run
from tests.simulation.recorded import b_train_run, event, small_run

NETCDF4 = find_spec("h5netcdf") is not None and find_spec("h5py") is not None
ENGINES = [
    pytest.param(True, b"\x89HDF", id="netCDF4", marks=pytest.mark.skipif(not NETCDF4, reason="needs h5netcdf")),
    pytest.param(False, b"CDF", id="netCDF3"),
]


def same_bits(found: Array, expected: Array) -> bool:
    """Whether two arrays are equal bit by bit, signs of zeros and what is no number included."""
    return np.ascontiguousarray(found, dtype=float).tobytes() == np.ascontiguousarray(expected, dtype=float).tobytes()


@pytest.fixture
def library(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """With the libraries of netCDF4, or as if they were not installed."""
    if not request.param:
        monkeypatch.setattr(files, "find_spec", lambda _: None)


@pytest.mark.parametrize(("library", "magic"), ENGINES, indirect=["library"])
@pytest.mark.parametrize("made", [small_run, b_train_run])
@pytest.mark.usefixtures("library")
def test_netcdf_gives_back_values_units_names_and_texts(tmp_path: Path, made: Any, magic: bytes) -> None:
    import xarray

    run: Run = made()
    path = run.save(tmp_path / "run.nc")
    assert path.read_bytes().startswith(magic)
    with xarray.open_dataset(path) as read:
        read.load()
    expected = run.data()
    assert read.attrs == expected.attrs
    assert set(read.variables) == set(expected.variables)
    for name in (*run.inputs.names, *run.outputs.names, *run.blocks.names):
        assert same_bits(read[name].values, run.of(name)), name
        assert read[name].attrs == expected[name].attrs
    assert same_bits(read["states"].values, run.states.values)
    assert same_bits(read["time"].values, run.time)
    assert tuple(read["state"].values) == run.states.names
    assert tuple(read["state_unit"].values) == run.states.units


@pytest.mark.parametrize(("library", "magic"), ENGINES, indirect=["library"])
@pytest.mark.usefixtures("library")
def test_netcdf_keeps_the_words_of_thousands_of_events(tmp_path: Path, magic: bytes) -> None:
    import xarray

    run = small_run(events=tuple(event("lift", f"axle_{k}.left", float(k)) for k in range(4000)))
    path = run.save(tmp_path / "run.nc")
    assert path.read_bytes().startswith(magic)
    with xarray.open_dataset(path) as read:
        assert read.attrs["events"].splitlines() == [str(item) for item in run.events]


@pytest.mark.parametrize(("library", "magic"), ENGINES, indirect=["library"])
@pytest.mark.parametrize("unit", [None, ""])
@pytest.mark.usefixtures("library")
def test_netcdf_holds_runs_without_states_or_units(tmp_path: Path, unit: str | None, magic: bytes) -> None:
    import xarray

    run = small_run()
    states = Channels((), (), (), run.states.values[:, :0])
    if unit is not None:
        states = run.states._replace(units=(unit,) * 3)
    path = replace(run, states=states).save(tmp_path / "run.nc")
    assert path.read_bytes().startswith(magic)
    with xarray.open_dataset(path) as read:
        assert ("states" in read) == bool(states.names)
        assert same_bits(read["tractor.ay"].values, run.of("tractor.ay"))
        assert list(read["state_unit"].values if states.names else []) == list(states.units)


def test_csv_gives_back_every_number(tmp_path: Path) -> None:
    run = small_run()
    path = run.save(tmp_path / "run.csv")
    read = np.loadtxt(path, delimiter=",", skiprows=1)
    assert same_bits(read[:, 0], run.time)
    for k, name in enumerate(run.names, 1):
        assert same_bits(read[:, k], run.of(name)), name


def test_csv_heads_each_column_with_name_and_unit(tmp_path: Path) -> None:
    first = small_run().save(tmp_path / "run.csv").read_text(encoding="utf-8").splitlines()[0]
    assert first == (
        "time [s],axle_1.steer [rad],tractor.ay [m/s^2],tractor_frame.roll [rad],axle_1.left.kappa [-],"
        "gyro.measured [rad/s],state:tractor_frame.roll [rad],state:tractor_frame.v_x [m/s],"
        "state:axle_1.left.spin [rad/s]"
    )


def at(read: Any, name: str) -> Any:
    """What a structure read from a file of MATLAB holds under a dotted name."""
    for part in name.split("."):
        read = read[part]
    return read


@pytest.mark.parametrize("made", [small_run, b_train_run])
def test_matlab_finds_values_and_units_under_dotted_names(tmp_path: Path, made: Any) -> None:
    from scipy.io import loadmat

    run: Run = made()
    read = loadmat(run.save(tmp_path / "run.mat"), simplify_cells=True)
    assert same_bits(read["run"]["time"], run.time)
    for group, before in ((run.inputs, ""), (run.outputs, ""), (run.blocks, ""), (run.states, "state.")):
        for name, unit in zip(group.names, group.units, strict=True):
            assert same_bits(at(read["run"], before + name), run.of(before.replace(".", ":") + name)), name
            assert "".join(at(read["units"], before + name)) == unit


def test_matlab_is_told_where_the_run_came_from_and_gets_columns(tmp_path: Path) -> None:
    from scipy.io import loadmat

    run = small_run(events=(event("lift", "axle_1.left", 1.0), event("lock", "axle_1.right", 2.0, 3.0)))
    path = run.save(tmp_path / "run.mat")
    about = loadmat(path, simplify_cells=True)["about"]
    assert {key: about[key] for key in run.identity} == run.identity
    assert about["events"].splitlines() == [str(item) for item in run.events]
    assert loadmat(path)["run"]["time"][0, 0].shape == (len(run.time), 1)


def test_names_that_matlab_cannot_have_are_changed_as_told(tmp_path: Path) -> None:
    from scipy.io import loadmat

    changed = {
        "2nd.ay": "x2nd.ay",
        "a-b.end": "a_b.xend",
        "_under.ä": "x_under.x_",
        f"{'long' * 20}.z": f"{('long' * 20)[:63]}.z",
    }
    run = small_run(outputs=tuple(changed))
    read = loadmat(run.save(tmp_path / "run.mat"), simplify_cells=True)
    for name, place in changed.items():
        assert same_bits(at(read["run"], place), run.of(name)), name


@pytest.mark.parametrize(
    ("outputs", "sentence"),
    [
        (("a-b", "a_b"), "signal a_b: MATLAB would know it as a_b, and so it would a-b"),
        (("time", "x"), "signal time: MATLAB would know it as time, and so it would time"),
        (
            ("tractor", "tractor.ay"),
            "signal tractor.ay: tractor cannot be a number and a structure at once: signal tractor",
        ),
        (
            ("tractor.ay", "tractor"),
            "signal tractor.ay: tractor cannot be a number and a structure at once: signal tractor",
        ),
    ],
)
def test_names_that_matlab_cannot_tell_apart_are_refused(
    tmp_path: Path, outputs: tuple[str, ...], sentence: str
) -> None:
    run = small_run(outputs=outputs)
    with pytest.raises(AnalysisError) as caught:
        run.save(tmp_path / "run.mat")
    assert str(caught.value) == sentence
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("name", "got"), [("run.xlsx", "the suffix .xlsx"), ("run", "no suffix")])
def test_another_suffix_is_answered_with_the_three(tmp_path: Path, name: str, got: str) -> None:
    with pytest.raises(AnalysisError, match=rf"expected a file name that ends in \.csv, \.nc or \.mat, got {got}$"):
        small_run().save(tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(AnalysisError, match=r"there is no folder .*missing to write to$"):
        small_run().save(tmp_path / "missing" / "run.csv")


@pytest.mark.parametrize("name", ["run.csv", "run.nc", "run.mat", "RUN.CSV", "RUN.MAT"])
def test_saving_gives_the_path_and_replaces_what_is_there(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text("old", encoding="utf-8")
    assert small_run().save(str(path)) == path
    assert [item.name for item in tmp_path.iterdir()] == [name]
    assert path.read_bytes() != b"old"
