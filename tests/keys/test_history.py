"""Keys of the history: pages by their numbers, and none that needs AltGr."""

from fleet_tui.keys.history import HISTORY, HISTORY_PAGES
from fleet_tui.keys.key import Pane, by_id
from tests.support.key_calls import calls

CALLS = calls(HISTORY)


def test_each_page_has_the_key_of_its_number() -> None:
    for number, name in enumerate(HISTORY_PAGES, 1):
        key = by_id(HISTORY)[f"history_{name.lower()}"]
        assert key.keys == (str(number),) and CALLS[key.id] == f"page({number})"


def test_the_other_keys_and_their_place() -> None:
    assert {key.pane for key in HISTORY} == {Pane.HISTORY}
    assert (CALLS["history_earlier"], CALLS["history_later"]) == ("shift(-1)", "shift(1)")
    assert (CALLS["history_longer"], CALLS["history_shorter"]) == ("stretch(1)", "stretch(-1)")
    assert CALLS["history_replay"] == "replay()" and CALLS["history_leave"] == "leave()"
