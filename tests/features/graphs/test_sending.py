"""The draft of a graph on its way to the robot."""

from pathlib import Path

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import GRAPH
from fleet_tui.model.set_up.commands import SendGraph
from tests.support.desk import ready
from tests.support.drawn_graph import drawn_graph
from tests.support.fleets import of_kinds


def takes_graphs() -> FleetState:
    plain = ready().robots["robot_0"].kind
    return of_kinds(ready(), replace(plain, accepts=(*plain.accepts, GRAPH)))


async def test_it_is_sent_after_a_question_and_the_present_graph_is_kept(tmp_path: Path) -> None:
    async with drawn_graph(tmp_path, state=takes_graphs()) as it:
        it.editor.start()
        it.at((9.0, 9.0))
        it.drawing.add_at_cursor()
        it.sending.start()
        (menu,) = it.desk.menus
        assert menu.title.startswith("1 difference from the live graph")
        menu.choose("Send to robot_0")
        assert it.desk.backend.submitted == []
        it.desk.say_yes()
        (sent,) = it.desk.backend.submitted
        assert isinstance(sent, SendGraph) and len(sent.vertices) == 3
        assert dict(sent.labels) == {"1": "Base", "2": "Store"}
    (kept,) = (tmp_path / "graphs").iterdir()
    assert "Base" in kept.read_text()


async def test_errors_stop_it() -> None:
    async with drawn_graph(state=takes_graphs()) as it:
        it.editor.start()
        it.mode.selected = "2"
        it.typed("name Base")
        it.sending.start()
        assert "not sent: 1 error" in it.desk.notices.text and not it.desk.menus


async def test_a_kind_that_takes_none_names_the_missing_key() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.sending.start()
        assert "graph" in it.desk.notices.text and not it.desk.menus


async def test_without_a_place_to_keep_the_present_graph_nothing_is_sent(tmp_path: Path) -> None:
    (tmp_path / "graphs").write_text("")
    async with drawn_graph(tmp_path, state=takes_graphs()) as it:
        it.editor.start()
        it.sending.start()
        it.desk.menus[0].choose("Send")
        it.desk.say_yes()
        assert "can't be kept" in it.desk.notices.text and not it.desk.backend.submitted
