"""Keys of the diagnostics screen: pages by their numbers, and keys that pages name."""

from fleet_tui.keys.diagnostics import DIAGNOSTICS, PAGES
from fleet_tui.keys.key import Pane

KEYS = {key.id: key for key in DIAGNOSTICS}


def test_each_page_has_the_key_of_its_number() -> None:
    for number, name in enumerate(PAGES, 1):
        assert KEYS[f"page_{name.lower()}"].keys == (str(number),)


def test_pages_name_keys_that_exist_and_all_work_on_this_screen_alone() -> None:
    assert {id_ for page in PAGES.values() for id_ in page.keys} <= set(KEYS)
    assert {key.pane for key in DIAGNOSTICS} == {Pane.DIAGNOSTICS}
