"""Frequency responses against python-control, closed forms and their own laws."""

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import eom
from eom.analysis import frequency_response, steady_gains
from eom.analysis.grid import frequency_grid
from tests.analysis.random_models import drifting_models, model_of, part, stable_models
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import NAMES, vehicle


@pytest.mark.parametrize("name", NAMES)
def test_responses_of_shipped_vehicles_are_those_of_python_control(name: str) -> None:
    model = eom.linearise(vehicle(name))
    reduced = model.without_cyclic()
    source = model.inputs[0]
    response = frequency_response(model, source, reduced.outputs)
    other = control.ss(reduced.A, reduced.B[:, [0]], reduced.C, reduced.D[:, [0]])
    expected = np.asarray(other(2j * np.pi * response.frequency, squeeze=False))[:, 0].T
    # two ways through the same matrices: rounding times the condition near a lightly damped root
    assert np.max(np.abs(response.values - expected)) <= 1e-8 * np.max(np.abs(expected))


@settings(max_examples=50, deadline=None, phases=PHASES)
@given(stable_models())
def test_the_response_tends_to_the_value_at_zero_frequency(model: eom.LinearModel) -> None:
    response = frequency_response(model, "u0", None, [0.0, 1e-9])
    # roots are 0.2 1/s or faster: the next term of the series is 2 pi 1e-9/0.2 times the size of the others
    assert response.values[1] == pytest.approx(response.values[0], rel=1e-4, abs=1e-4)


@settings(max_examples=30, deadline=None, phases=PHASES)
@given(drifting_models())
def test_at_zero_frequency_the_steady_gain_is_taken_integrators_included(model: eom.LinearModel) -> None:
    response = frequency_response(model, "u0", None, [0.0, 1.0])
    assert np.array_equal(response.magnitude[0], np.abs(steady_gains(model).values[:, 0]))


def test_a_ratio_is_the_quotient_of_two_responses() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    names = ("semitrailer_2.ay/tractor.ay", "semitrailer_2.ay", "tractor.ay", "semitrailer_2.ay/tractor.yaw_rate")
    response = frequency_response(model, "axle_1.steer", names)
    assert response.values[:, 0] == pytest.approx(response.values[:, 1] / response.values[:, 2], rel=1e-14)
    assert response.units == ("", "m/s^2 per rad", "m/s^2 per rad", "m/s^2 per rad/s")
    # in a steady turn all units have the same lateral acceleration, by 1e-9 Hz all but exactly
    assert frequency_response(model, "axle_1.steer", names, [0.0]).values[0, 0] == pytest.approx(1.0, abs=1e-12)


@settings(max_examples=60, deadline=None, phases=PHASES)
@given(st.floats(1e-4, 0.65), st.floats(0.05, 500.0))
def test_the_peak_of_an_oscillator_is_that_of_its_closed_form(damping: float, omega: float) -> None:
    A = np.array([[0.0, 1.0], [-(omega**2), -2.0 * damping * omega]])
    model = model_of(A, np.array([[0.0], [omega**2]]), np.array([[1.0, 0.0]]))
    (peak,) = frequency_response(model, "u0").peaks()
    assert peak.inside
    # a flat top: the place is known to the root of the height's rounding, over the damping at most
    assert peak.frequency == pytest.approx(omega * np.sqrt(1.0 - 2.0 * damping**2) / (2.0 * np.pi), rel=1e-6)
    assert peak.value == pytest.approx(1.0 / (2.0 * damping * np.sqrt(1.0 - damping**2)), rel=1e-9)


@pytest.mark.parametrize("name", ["b_train_yaw_roll", "full_car", "double_wishbone_car"])
def test_no_frequency_of_a_finer_grid_beats_a_peak(name: str) -> None:
    model = eom.linearise(vehicle(name))
    response = frequency_response(model, model.inputs[0])
    f = response.frequency
    fine = frequency_response(model, model.inputs[0], None, np.geomspace(f[0], f[-1], 20_000)).magnitude
    for peak, column in zip(response.peaks(), fine.T, strict=True):
        assert column.max() <= peak.value * (1.0 + 1e-9) + 1e-300


def test_a_peak_at_the_end_of_the_range_is_told_as_such() -> None:
    model = model_of(np.array([[-1.0]]), np.array([[1.0]]), np.array([[1.0]]))
    (peak,) = frequency_response(model, "u0", None, [0.01, 0.1, 1.0]).peaks()
    assert (peak.frequency, peak.inside) == (0.01, False)


@settings(max_examples=50, deadline=None, phases=PHASES)
@given(st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_the_phase_is_the_sum_of_the_angles_from_zeros_and_poles(pairs: int, seed: int) -> None:
    """Continuous from a low to a high frequency, over as many turns as there are."""
    rng = np.random.default_rng(seed)
    poles = -rng.uniform(0.05, 1.0, pairs) + 1j * rng.uniform(0.3, 30.0, pairs)
    blocks = [np.array([[0.0, 1.0], [-(abs(p) ** 2), 2.0 * p.real]]) for p in poles]
    A = np.zeros((2 * pairs, 2 * pairs))
    for k, block in enumerate(blocks):
        A[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = block
        if k:
            # a chain: each oscillator is driven by the one before
            A[2 * k + 1, 2 * k - 2] = abs(poles[k]) ** 2
    B, C = np.zeros((2 * pairs, 1)), np.zeros((1, 2 * pairs))
    B[1], C[0, -2] = abs(poles[0]) ** 2, 1.0
    response = frequency_response(model_of(A, B, C), "u0")
    s = 2j * np.pi * response.frequency[:, np.newaxis]
    expected = -np.sum(np.angle(s - poles) + np.angle(s - poles.conj()), axis=1)
    # a product of up to twelve factors in a chain that loses magnitude to 1e-24: its angle keeps nine digits
    strong = response.magnitude[:, 0] > 1e-12
    assert response.phase[strong, 0] == pytest.approx(expected[strong], abs=1e-6)


def test_the_default_grid_holds_every_resonance() -> None:
    model = eom.linearise(vehicle("full_car"))
    grid = frequency_grid(model)
    roots = model.modes().eigenvalues
    for root in roots[roots.imag > 0.0]:
        # a point within half a half-width of each damped frequency
        near = np.min(np.abs(2.0 * np.pi * grid - root.imag))
        assert near <= 0.5 * abs(root.real)


def test_every_unknown_name_gets_its_sentence() -> None:
    model = eom.linearise(vehicle("b_train_yaw_plane"))
    with pytest.raises(eom.AnalysisError) as error:
        frequency_response(model, "axle_1.steeer", ["tractor.az", "a/b/c", "tractor.ay/semitrailer_3.ay"])
    lines = str(error.value).splitlines()
    assert "input axle_1.steeer: there is no such input; did you mean 'axle_1.steer'?" in lines
    assert "output tractor.az: there is no such output; did you mean 'tractor.ay'?" in lines
    assert "output a/b/c: expected the name of an output, or two with one '/' between them" in lines
    assert any(line.startswith("output semitrailer_3.ay") for line in lines)
    assert len(lines) == 4


@pytest.mark.parametrize("frequency", [[-1.0], [1.0, 1.0], [np.nan], [2.0, 1.0]])
def test_frequencies_that_are_none_are_refused(frequency: list[float]) -> None:
    model = eom.linearise(vehicle("quarter_car"))
    with pytest.raises(eom.AnalysisError, match="expected finite numbers in Hz"):
        frequency_response(model, "road", None, frequency)


def test_at_a_pole_on_the_imaginary_axis_the_response_is_infinite_where_it_is_seen() -> None:
    A = np.array([[0.0, 1.0, 0.0], [-((2.0 * np.pi) ** 2), 0.0, 0.0], [0.0, 0.0, -1.0]])
    model = model_of(A, np.array([[0.0], [1.0], [1.0]]), np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    found = frequency_response(model, "u0", None, [0.5, 1.0, 2.0])
    assert not found.stable
    assert np.isinf(found.magnitude[1, 0])
    # beside the pole, a lag of 1 s
    assert found.magnitude[:, 1] == pytest.approx(1.0 / np.abs(2j * np.pi * found.frequency + 1.0), rel=1e-8)
    assert np.all(np.isfinite(found.magnitude[[0, 2]]))


def test_the_peak_at_an_undamped_root_is_infinite() -> None:
    A = np.array([[0.0, 1.0, 0.0], [-9.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
    model = model_of(A, np.array([[0.0], [1.0], [1.0]]), np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    swinging, quiet = frequency_response(model, "u0").peaks()
    assert (swinging.value, swinging.inside) == (np.inf, True)
    assert swinging.frequency == pytest.approx(3.0 / (2.0 * np.pi))
    assert quiet.value <= 1.0


def test_the_picture_has_a_panel_for_each_unit_and_one_for_phase() -> None:
    model = eom.linearise(vehicle("b_train_yaw_roll"))
    names = ("tractor.ay", "semitrailer_2.ay", "tractor.yaw_rate", "semitrailer_2.ay/tractor.ay")
    figure = frequency_response(model, "axle_1.steer", names).plot()
    assert [axes.get_ylabel() for axes in figure.axes] == ["m/s^2 per rad", "rad/s per rad", "ratio [-]", "phase [deg]"]
    assert [len(axes.lines) for axes in figure.axes] == [2, 1, 1, 4]


def test_an_infinite_value_at_zero_leaves_the_other_phases_alone() -> None:
    """An integrator behind a lag: the phase starts at -90 degrees, which zero frequency itself does not have."""
    model = model_of(np.array([[0.0, 1.0], [0.0, -1.0]]), np.array([[0.0], [1.0]]), np.eye(2), cyclic=(0,))
    response = frequency_response(model, "u0", ["y0", "y0/y1", "y1/y0"], [0.0, 1e-6, 1e-3])
    assert response.magnitude[0] == pytest.approx([np.inf, np.inf, 0.0])
    assert np.isnan(response.phase[0, :2]).all()
    assert response.phase[1] == pytest.approx(np.array([-0.5, -0.5, 0.5]) * np.pi, abs=1e-4)
    assert np.isfinite(response.phase[1:]).all()


def test_the_columns_of_a_response_are_the_outputs_asked_for() -> None:
    model = eom.linearise(vehicle("quarter_car"))
    response = frequency_response(model, "road", ["tyre_deflection"], [1.0, 2.0])
    A, B, C, D = part(model, "road", "tyre_deflection")
    s = 2j * np.pi * 2.0
    expected = (C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D)[0, 0]
    assert response.values[1, 0] == pytest.approx(expected, rel=1e-13)
