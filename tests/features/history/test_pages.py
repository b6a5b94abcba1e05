"""Times on the pages of the history."""

from fleet_tui.features.history.overlay import long_moment


def test_a_long_moment_has_its_date() -> None:
    assert len(long_moment(1e9)) == len("09-09 01:46:40") and long_moment(1e9)[:5] in ("09-09", "09-08")
