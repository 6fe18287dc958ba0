"""What chapter 4 of S. Zhu's thesis prints of the linear model, against the generated one.

Printed values have three decimals: half a unit of the last one is theirs.
"""

import numpy as np
import pytest

from eom.analysis import frequency_response, steady_gains
from tools import thesis_chapter4 as chapter


def test_table_4_4_is_reproduced_to_a_thousandth_of_g() -> None:
    rows = chapter.table_4_4()
    assert len(rows) == 8
    for row in rows:
        # one unit of the last printed digit, as its own rounding of the time at a slope of up to 0.1 g/s allows
        assert abs(round(row.ours, 3) - row.printed) <= 0.001 + 1e-12, row


def test_table_4_5_is_reproduced_to_0_3_percent_with_labels_one_step_late() -> None:
    rows = chapter.table_4_5()
    assert len(rows) == 6
    for row in rows:
        assert row.ours == pytest.approx(row.printed, rel=0.003), row


def test_table_4_5_is_not_reproduced_at_its_own_labels() -> None:
    """Neither measured in time nor by transfer functions: the lag is in the table."""
    for rows in (chapter.table_4_5(late=0), chapter.gains_at_labels()):
        assert max(abs(row.ours / row.printed - 1.0) for row in rows) > 0.05


def test_table_4_6_is_reproduced_with_a_reading_for_each_frequency() -> None:
    for row in chapter.table_4_6():
        assert row.ours == pytest.approx(row.printed, rel=0.008), row
    linear = chapter.model()
    # no single reading gives all three
    for reading in chapter.READINGS:
        errors = [chapter.amplification(linear, f, reading) / printed - 1.0 for f, printed in chapter.TABLE_4_6.items()]
        assert max(map(abs, errors)) > 0.06


def test_table_4_2_does_not_follow_from_the_printed_parameters() -> None:
    early, late = chapter.table_4_2(chapter.model())
    assert [early.ours, late.ours] == pytest.approx([1.0985, 0.5628], abs=5e-5)
    _, miss = chapter.nearest_speed()
    assert miss > 0.2


def test_stiffer_tyres_would_give_table_4_2() -> None:
    stiffer = chapter.model(factors=chapter.STIFFER)
    for row in (*chapter.table_4_2(stiffer), *chapter.measured_rows(stiffer)):
        assert row.ours == pytest.approx(row.printed, rel=0.01), row


def test_the_tables_belong_to_150_km_h() -> None:
    """Near zero frequency the printed gain of 7.48 g/rad is the steady one at that speed alone."""
    fast, slow = (
        steady_gains(chapter.model(speed)).of(chapter.TRACTOR, chapter.STEER) / 9.8 for speed in ("150 km/h", "88 km/h")
    )
    # at 0.01 Hz the gain is the steady one to 4e-5
    assert fast == pytest.approx(7.478, rel=2e-4)
    assert slow == pytest.approx(5.763, abs=5e-4)


def test_measuring_errs_little_without_lag_and_as_printed_with_it() -> None:
    """The thesis prints at most 4.72 %, near 0.76 Hz."""
    linear = chapter.model()
    aligned, late = (chapter.error_of_measuring(linear, lag) for lag in (0, 1))
    assert np.max(np.abs(aligned)) == pytest.approx(2.28, abs=0.01)
    assert np.max(np.abs(late)) == pytest.approx(5.55, abs=0.01)


def test_measuring_with_many_cycles_gives_the_transfer_function() -> None:
    """The technique itself is right: only the single cycle and the state carried over make its error."""
    linear = chapter.model()
    f = 0.5
    gains = chapter.measured_response(linear, np.full(12, f))
    exact = frequency_response(linear, chapter.STEER, chapter.UNITS, [f]).magnitude[0] / 9.8
    # 24 s of decay at 1 1/s or faster; the trapezoidal rule's 1e-6
    assert gains[-1] == pytest.approx(exact, rel=1e-5)
    assert gains[0] != pytest.approx(exact, rel=1e-3)
