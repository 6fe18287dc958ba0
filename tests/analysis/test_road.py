"""Random roads and the vibration on them: integrals, closed forms, Lyapunov equations, sums of plane waves."""

import numpy as np
import pytest
import scipy.integrate
import scipy.special
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import solve_continuous_lyapunov

import eom
from eom.analysis import displacement_psd, road_response, track_coherence
from eom.analysis.road import CLASSES
from tests.assembly.systems import PHASES
from tests.vehicles.shipped import vehicle

Array = np.ndarray
SPEED = 20.0
ENDLESS = (1e-7, 1e7)


def test_the_classes_are_those_of_iso_8608() -> None:
    """Geometric means of G_d(n0) in 1e-6 m^3, as the standard's table of classes prints them."""
    printed = dict(zip("ABCDEFGH", (16, 64, 256, 1024, 4096, 16384, 65536, 262144), strict=True))
    assert {name: value * 1e6 for name, value in CLASSES.items()} == pytest.approx(printed)
    assert displacement_psd(CLASSES["C"], [0.1, 1.0]) == pytest.approx([256e-6, 2.56e-6])


@settings(max_examples=40, deadline=None, phases=PHASES)
@given(st.floats(0.01, 5.0), st.floats(0.05, 3.0))
def test_tracks_go_together_as_those_of_an_isotropic_road(n: float, distance: float) -> None:
    """The sum over all waves (n, m) of an isotropic PSD (n^2 + m^2)^(-3/2), numerically."""

    def density(m: float) -> float:
        return float((n**2 + m**2) ** -1.5)

    cross, _ = scipy.integrate.quad(
        density, 0.0, np.inf, weight="cos", wvar=2.0 * np.pi * distance, epsabs=1e-12 / n**2, limlst=200
    )
    own, _ = scipy.integrate.quad(density, 0.0, np.inf)
    # the quadrature's tolerance relative to the whole
    assert float(track_coherence(n, distance)) == pytest.approx(cross / own, abs=1e-8)
    # the single track has the PSD that the classes are defined by
    assert own * n**2 == pytest.approx(1.0, rel=1e-8)


def test_one_track_is_itself_and_far_tracks_are_strangers() -> None:
    assert track_coherence([0.01, 1.0, 10.0], 0.0) == pytest.approx([1.0, 1.0, 1.0])
    assert float(track_coherence(10.0, 1.5)) < 1e-35
    assert np.all(np.diff(track_coherence(np.geomspace(1e-9, 1.0, 200), 1.5)) <= 0.0)


def variances(model: eom.LinearModel, roughness: float, speed: float) -> dict[str, float]:
    """Variances of outputs that stay finite, by the Lyapunov equation of motion counted from the road.

    The road's rate is white noise of the two-sided PSD 2 pi^2 G_d(n0) n0^2 speed. States are counted from where the
    vehicle would stand on a road that stays as high as it is.
    """
    (b,) = model.B.T
    stand = -np.linalg.solve(model.A, b)
    intensity = 2.0 * np.pi**2 * roughness * 0.1**2 * speed
    P = solve_continuous_lyapunov(model.A, -intensity * np.outer(stand, stand))
    finite = np.abs(model.C @ stand + model.D[:, 0]) < 1e-9
    return {name: float(row @ P @ row) for name, row, ends in zip(model.outputs, model.C, finite, strict=True) if ends}


@pytest.mark.parametrize("changes", [{}, {"c_t": 0.0}, {"c_s": 300.0}, {"k_t": 90e3, "c_s": 4000.0}])
def test_a_quarter_car_vibrates_as_lyapunovs_equation_says(changes: dict[str, float]) -> None:
    car = vehicle("quarter_car", **changes)
    response = road_response(car, "C", speed=SPEED, band=ENDLESS)
    expected = variances(eom.linearise(car), CLASSES["C"], SPEED)
    assert len(expected) == 3
    for name, value in expected.items():
        # the band leaves out frequencies below 1e-7 and above 1e7 Hz: the PSDs fall as f^2 and 1/f^2 there or faster
        assert response.rms_of(name) ** 2 == pytest.approx(value, rel=1e-5)


def test_a_quarter_car_has_the_variances_of_the_textbooks() -> None:
    """Closed forms without tyre damping.

    S is the road rate's two-sided PSD. See S. Turkay and H. Akcay, A study of random vibration characteristics of the
    quarter-car model, J. Sound and Vibration 282 (2005).
    """
    m_s, m_u, k_s, c_s, k_t = 300.0, 40.0, 20e3, 1500.0, 200e3
    S = 2.0 * np.pi**2 * CLASSES["B"] * 0.1**2 * SPEED
    response = road_response(vehicle("quarter_car", c_t=0.0), "B", speed=SPEED, band=ENDLESS)
    assert response.rms_of("suspension_travel") ** 2 == pytest.approx(S * (m_s + m_u) / (2.0 * c_s), rel=1e-6)
    acceleration = S / (2.0 * m_s**2) * (k_t * c_s + (m_s + m_u) * k_s**2 / c_s)
    assert response.rms_of("sprung_acceleration") ** 2 == pytest.approx(acceleration, rel=1e-6)


@pytest.mark.parametrize("frequency", [0.4, 1.3, 3.7, 11.0])
def test_a_full_car_vibrates_as_a_sum_of_plane_waves(frequency: float) -> None:
    """Waves of an isotropic road run under the car in every direction; their responses' densities add up."""
    car = vehicle("full_car")
    model = eom.linearise(car)
    H = model.frequency_response(frequency)[0]
    places = np.array([item.connection.places[0] for item in car.system.inputs])
    n = frequency / model.speed

    def amplitude(m: float) -> Array:
        # a place at x sees the wave as it was x/U later on, one at y by the lateral phase
        waves = np.exp(2j * np.pi * (n * places[:, 0] + m * places[:, 1]))
        return np.asarray(np.abs(H @ waves) ** 2)

    def integrand(angle: float) -> Array:
        # m = n tan(angle): (n^2 + m^2)^(-3/2) dm/2 = cos(angle) d(angle)/(2 n^2)
        return np.asarray(amplitude(n * np.tan(angle)) * np.cos(angle) / (2.0 * n**2))

    total, _ = scipy.integrate.quad_vec(integrand, -np.pi / 2, np.pi / 2, epsrel=1e-10, epsabs=0.0, limit=5000)
    expected = CLASSES["D"] * 0.1**2 * total / model.speed
    response = road_response(car, "D", band=(frequency, frequency * 2.0))
    # waves across the road oscillate without end under the weight cos(angle): quadrature to 1e-6
    assert response.psd[0] == pytest.approx(expected, rel=1e-6)


def test_the_rms_is_the_root_of_the_area_under_the_psd() -> None:
    response = road_response(vehicle("full_car"), "C", band=(0.5, 80.0))
    assert response.band == (0.5, 80.0)
    # the trapezoidal rule on the grid that is drawn
    area = np.trapezoid(response.psd, response.frequency, axis=0)
    assert np.sqrt(area) == pytest.approx(response.rms, rel=5e-3)


def test_each_class_is_twice_as_rough_as_the_one_before() -> None:
    car = vehicle("quarter_car")
    one, two = (road_response(car, name, speed=SPEED) for name in "AB")
    assert two.rms == pytest.approx(2.0 * one.rms, rel=1e-12)
    assert road_response(car, 16e-6, speed=SPEED).rms == pytest.approx(one.rms, rel=1e-12)
    # 0.01 to 10 1/m
    assert one.band == (0.2, 200.0)


def test_the_picture_has_a_panel_for_each_unit() -> None:
    figure = road_response(vehicle("quarter_car"), "C", speed=SPEED).plot()
    assert [axes.get_ylabel() for axes in figure.axes] == ["[m/s^2/√Hz]", "[m/√Hz]"]


def test_every_mistake_of_a_request_gets_its_sentence() -> None:
    with pytest.raises(eom.AnalysisError) as error:
        road_response(vehicle("pendulum_cart"), "I", outputs=["angel"])
    text = str(error.value)
    for piece in ("no input is a height of the road", "expected a class of ISO 8608", "give a speed", "is unstable"):
        assert piece in text
    assert "did you mean 'angle'?" in text
    assert len(text.splitlines()) == 5
    with pytest.raises(eom.AnalysisError, match="the trim's speed is 20 m/s"):
        road_response(vehicle("full_car"), "A", speed=10.0)
    with pytest.raises(eom.AnalysisError, match="expected 0 < from < to"):
        road_response(vehicle("full_car"), "A", band=(3.0, 1.0))
    with pytest.raises(eom.AnalysisError, match="expected a positive roughness"):
        road_response(vehicle("full_car"), -1.0)
