"""Keys of the history: pages by their numbers, and none that needs AltGr."""

from fleet_tui.keys.history import HISTORY, HISTORY_PAGES
from fleet_tui.keys.key import Pane


def test_each_page_has_the_key_of_its_number() -> None:
    for number, name in enumerate(HISTORY_PAGES, 1):
        (key,) = (one for one in HISTORY if one.id == f"history_{name.lower()}")
        assert key.keys == (str(number),)


def test_all_work_in_the_history_alone() -> None:
    assert {key.pane for key in HISTORY} == {Pane.HISTORY}
