"""The pages tell of the keys and the words there are for a kind of robot."""

import pytest

from fleet_tui.keys import KEYS as ROWS
from fleet_tui.keys import Pane
from fleet_tui.model.kind import Kind
from fleet_tui.ui.view.help.pages import Pages, help_pages, tabs
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import text_of
from tests.support.kinds import BARE, FULL, KEEPING, KEYS


def pages(pane: Pane = Pane.MAP, kind: Kind = FULL, hidden: frozenset[str] = frozenset()) -> Pages:
    return help_pages(KEYS, pane, kind, hidden, MapOptions(), "terminal: xterm")


def text(shown: Pages, page: str) -> str:
    rows = [row for section in shown[page] for row in section.rows]
    return "\n".join(f"{text_of(row.mark)} {row.text}" for row in rows)


def test_every_key_of_use_is_listed_without_its_id() -> None:
    hidden = frozenset({"clear"})
    listed = text(pages(hidden=hidden), "Keys")
    missing = [key.text for key in ROWS if key.id != "clear" and key.text not in listed]
    assert all(text.startswith("Select the robot") for text in missing)
    assert "1 2 3" not in listed and "1..9" in listed
    assert "Clear all orders" not in listed and "pause_all" not in listed


@pytest.mark.parametrize("pane", list(Pane))
def test_the_keys_of_the_focused_pane_come_first(pane: Pane) -> None:
    shown = pages(pane)
    assert shown["Keys"][0].title == pane.value
    own = pane not in (Pane.MAP, Pane.ROWS, Pane.CONSOLE)
    assert (shown["Tasks"][0].title == pane.value) is own


def test_help_tells_of_what_can_be_typed() -> None:
    assert "pause all" in text(pages(), "Commands") and "cargo on board to B" in text(pages(), "Commands")
    bare = text(pages(kind=BARE), "Commands").partition("Robots go by")[0]
    assert [word for word in ("pause", "cancel", "clear", "cargo") if word in bare] == []
    assert "directly to B" in bare
    assert "terminal: xterm" in text(pages(), "Commands")
    assert "goto robot_0" not in text(pages(), "Commands") and "save config.toml" in text(pages(), "Commands")
    assert "goto robot_0 3.5 2 90" in text(pages(kind=KEEPING), "Commands")


def test_tabs_have_their_cells() -> None:
    shown = pages()
    runs, buttons = tabs(shown, "Legend")
    line = text_of(runs)
    assert "[Legend]" in line and line.count("[") == 1
    assert [line[one.start : one.end].strip(" []") for one in buttons] == list(shown)
    assert buttons[-1].end == width_of(runs)
