"""A sine as pieces: its values, as many as a run needs, and when its pieces would be too many."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from eom.errors import SimulationError
from eom.simulation import Sine
from eom.simulation.signal_pieces import MOST, PER_CYCLE, sine

DURATION = 2.0


@given(st.floats(0.01, 30.0), st.floats(-3.0, 3.0), st.floats(0.05, 1e6), st.floats(0.0, DURATION))
def test_a_sine_is_that_of_numpy_until_the_duration(frequency: float, start: float, cycles: float, t: float) -> None:
    found = sine(Sine(1.0, frequency, start, cycles), "u", DURATION)
    piece = int(np.searchsorted(found.rows[:, 0], t, side="right")) - 1
    begin, *coefficients = found.rows[max(piece, 0)]
    value = np.polynomial.polynomial.polyval(t - begin, coefficients)
    inside = start <= t < start + cycles / frequency
    expected = np.sin(2.0 * np.pi * frequency * (t - start)) if inside else 0.0
    # the coefficients are sums of terms up to 7e3, each rounded to 1e-16 of it
    assert value == pytest.approx(expected, abs=1e-11)


@given(st.floats(0.01, 30.0), st.floats(0.0, 3.0), st.floats(1.0, 1e12))
def test_pieces_are_those_until_the_duration_alone(frequency: float, start: float, cycles: float) -> None:
    found = sine(Sine(1.0, frequency, start, cycles), "u", DURATION)
    assert len(found.rows) <= DURATION * frequency * PER_CYCLE + PER_CYCLE + 3


def test_a_sine_of_too_many_pieces_is_refused() -> None:
    most = MOST // PER_CYCLE
    with pytest.raises(SimulationError, match=f"input u: 1e\\+06 cycles until 2 s, expected at most {most}"):
        sine(Sine(1.0, 5e5, 0.0, 1e9), "u", DURATION)
    with pytest.raises(SimulationError, match="cycles until 2 s"):
        sine(Sine(1.0, 1e300, 0.0, 1e300), "u", DURATION)
