"""Stability maps against eigenvalues of the same vehicles and against critical values."""

import numpy as np
import pytest
from matplotlib.contour import ContourSet

import eom
from eom.analysis.maps import Axis, stability_map
from tests.vehicles.shipped import vehicle

SPEEDS, PLACES = Axis("U", np.linspace(90.0, 130.0, 5).tolist(), "km/h"), Axis("ahead", [0.0, 0.05, 0.1, 0.15], "m")


def test_every_point_has_the_rightmost_and_least_damped_roots_of_the_vehicle_with_its_values() -> None:
    found = stability_map(vehicle("car_trailer"), SPEEDS, PLACES)
    assert found.rightmost.shape == found.damping.shape == (5, 4)
    for i, U in enumerate(SPEEDS.values):
        for k, ahead in enumerate(PLACES.values):
            model = eom.linearise(vehicle("car_trailer", U=f"{U} km/h", ahead=ahead)).without_cyclic()
            roots = np.linalg.eigvals(model.A)
            oscillating = roots[roots.imag > 0.0]
            # the same matrices
            assert found.rightmost[i, k] == pytest.approx(np.max(roots.real), rel=1e-12)
            assert found.damping[i, k] == pytest.approx(np.min(-oscillating.real / np.abs(oscillating)), rel=1e-12)


def test_the_border_drawn_meets_the_critical_speeds() -> None:
    figure = stability_map(vehicle("car_trailer"), SPEEDS, PLACES).plot()
    (border,) = (item for item in figure.axes[0].collections if isinstance(item, ContourSet) and not item.filled)
    line = np.asarray(border.get_paths()[0].vertices)
    places = line[:, 1]
    for ahead in (0.05, 0.1):
        (item,) = eom.critical_values(vehicle("car_trailer", ahead=ahead), "U", (90.0, 130.0), "km/h")
        speed = line[np.argmin(np.abs(places - ahead)), 0]
        # interpolation over 10 km/h of a curve that bends little: a few per cent of a step
        assert speed == pytest.approx(item.value, abs=0.5)


def test_an_undamped_vehicle_lies_exactly_on_the_border() -> None:
    found = stability_map(vehicle("ziegler_column"), Axis("P", [50.0, 150.0, 250.0]), Axis("m", [1.0, 2.0]))
    np.testing.assert_array_equal(found.rightmost[:2], 0.0)
    assert np.all(found.rightmost[2] > 0.0)
    # 5 rad/s or so, undamped to rounding
    np.testing.assert_allclose(found.damping[:2], 0.0, atol=1e-9)


def test_a_map_where_nothing_oscillates_says_so() -> None:
    car = vehicle("pendulum_cart")
    assert not np.any(eom.linearise(car).modes().oscillates)
    found = stability_map(car, Axis("M", [0.5, 0.6]), Axis("m", [0.2, 0.3]))
    assert np.all(np.isnan(found.damping))
    assert "nothing oscillates" in {text.get_text() for axes in found.plot().axes for text in axes.texts}


def test_one_parameter_twice_is_refused() -> None:
    with pytest.raises(eom.AnalysisError, match="expected two parameters, got the same one twice"):
        stability_map(vehicle("car_trailer"), SPEEDS, SPEEDS)


def test_a_map_of_one_line_has_no_picture() -> None:
    found = stability_map(vehicle("car_trailer"), Axis("U", [20.0]), PLACES)
    with pytest.raises(eom.AnalysisError, match="contours need two values along each parameter"):
        found.plot()
