"""The lines above and below a page of the diagnostics screen."""

from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.lines.diagnostics import foot_runs, page_runs
from fleet_tui.ui.view.tables.table import width_of


def test_the_shown_page_stands_in_brackets_and_what_is_frozen_is_said() -> None:
    left, right = page_runs(["Link", "Topics"], 2, "frozen 12 s ago")
    assert "".join(part for part, _ in left) == " 1 Link [2 Topics]"
    assert right[0][0] == "frozen 12 s ago"


def test_every_page_has_its_keys_and_what_was_said_takes_their_place() -> None:
    from fleet_tui.keys import KEYS

    keys = {key.id: key.keys for key in KEYS}
    for page in range(1, 7):
        _, right = foot_runs(keys, page, EMPTY)
        assert width_of(right) <= 75 and "back" in right[-1][0]
    left, right = foot_runs(keys, 3, Message("sent"))
    assert left[0][0] == "sent" and right == []
