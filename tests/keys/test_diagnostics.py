"""Keys of the diagnostics screen: pages by their numbers, and keys that pages name."""

from fleet_tui.keys.diagnostics import DIAGNOSTICS, PAGES
from fleet_tui.keys.key import Pane, by_id
from tests.support.key_calls import calls

CALLS = calls(DIAGNOSTICS)


def test_each_page_has_the_key_of_its_number() -> None:
    for number, name in enumerate(PAGES, 1):
        key = by_id(DIAGNOSTICS)[f"page_{name.lower()}"]
        assert key.keys == (str(number),) and CALLS[key.id] == f"page({number})"
    assert (CALLS["next_page"], CALLS["previous_page"]) == ("step_page(1)", "step_page(-1)")


def test_pages_name_keys_that_exist_and_all_work_on_this_screen_alone() -> None:
    assert {id_ for page in PAGES.values() for id_ in page.keys} <= set(CALLS)
    assert {key.pane for key in DIAGNOSTICS} == {Pane.DIAGNOSTICS}
