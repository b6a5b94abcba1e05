"""A time in equal parts."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.records.history.division import EXACT, divided
from fleet_tui.records.history.observing import HOUR

DAY = 24 * HOUR


@given(st.floats(0.0, 2e9), st.floats(60.0, 90 * DAY), st.integers(2, 400), st.floats(-0.2, 1.2))
def test_the_parts_cover_the_time(since: float, seconds: float, most: int, where: float) -> None:
    time = divided(since, since + seconds, most)
    assert time.since <= since and time.until >= since + seconds and 1 <= time.parts <= most
    at = since + where * seconds
    part = time.part(at)
    assert 0 <= part < time.parts
    if time.since <= at < time.until:
        assert time.since + part * time.step <= at + 1e-3 and at <= time.since + (part + 1) * time.step + 1e-3
    if seconds > EXACT:
        assert time.since % HOUR == 0.0 and round(time.step, 6) % HOUR == 0.0


def test_a_shift_is_divided_exactly_and_a_month_at_hours() -> None:
    assert divided(100.0, 100.0 + 8 * HOUR, 240).step == 120.0
    longest = divided(1000.0, 1000.0 + EXACT, 240)
    assert (longest.since, longest.parts) == (1000.0, 240) and longest.is_exact
    month = divided(1000.0, 1000.0 + 30 * DAY, 240)
    assert (month.since, month.step, month.parts) == (0.0, 4 * HOUR, 181) and not month.is_exact
