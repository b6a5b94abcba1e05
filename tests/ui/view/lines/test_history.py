"""First and last line of the history."""

from fleet_tui.keys.keymap import keymap
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.lines.history import foot_runs, page_runs
from tests.support.fleets import text_of

KEYS, _ = keymap({})


def test_the_open_page_is_in_brackets_and_the_time_at_the_right() -> None:
    pages, time = page_runs(2, "8 h", "now", 80)
    assert text_of(page_runs(2, "8 h", "now", 58)[0]) == "History [2 of 5 Robots]"
    assert text_of(pages) == "History  1 Events [2 Robots] 3 Batteries  4 Alarms  5 Places "
    assert text_of(time) == "8 h to now "


def test_each_page_offers_the_recording_and_that_of_places_its_floors() -> None:
    for page, first in (("Events", " o recording "), ("Robots", " o recording "), ("Places", " f floor ")):
        hints = text_of(foot_runs(KEYS, page, EMPTY)[1])
        assert hints.startswith(first) and " o recording  / filter " in hints


def test_an_answer_takes_the_place_of_the_keys() -> None:
    said, keys = foot_runs(KEYS, "Events", Message("no recording [2J"))
    assert text_of(said) == "no recording ␛[2J" and keys == []
