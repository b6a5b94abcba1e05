"""Times of programs, as an operator reads them; what the keys do is in tests/screens/test_programs.py."""

import time

from fleet_tui.ui.controllers.local_time import since_text


def test_a_time_of_today_has_seconds_and_an_older_one_its_date() -> None:
    now = time.time()
    assert since_text(now) == time.strftime("%H:%M:%S", time.localtime(now))
    assert since_text(0.0) == time.strftime("%m-%d %H:%M", time.localtime(0.0))
    assert since_text(1e30) == "no time"
