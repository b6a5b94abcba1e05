"""The graph file that a robot loads: written after the yes, followed until the robot has answered."""

import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.features.graphs.sending import DraftSending
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, FloorGraphLoaded
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graphs.document import DocumentEdge
from fleet_tui.model.graphs.draft import Change
from fleet_tui.model.kind import GRAPH
from fleet_tui.model.set_up.commands import SendGraph
from fleet_tui.text.language import Message
from tests.support.desk import ready
from tests.support.drawn_graph import DrawnGraph, drawn_graph
from tests.support.fleets import F0, R0, T0, of_kinds
from tests.support.users import give, two_users

OLD = """{"type": "FeatureCollection", "features": [
{"properties": {"id": 1, "note": 7}, "geometry": {"type": "Point", "coordinates": [0.0, 0.0]}},
{"properties": {"id": 2}, "geometry": {"type": "Point", "coordinates": [9.0, 0.0]}}]}
"""


def loads() -> FleetState:
    plain = ready().robots[R0].kind
    reports = tuple(one for one in plain.reports if one not in ("graph", "labels"))
    return of_kinds(ready(), replace(plain, reports=reports, accepts=(GRAPH,), loads_graphs=True))


@asynccontextmanager
async def drawn(folder: Path) -> AsyncIterator[DrawnGraph]:
    """A draft with a third vertex and a way to it, and the file of its floor."""
    async with drawn_graph(folder, state=loads()) as it:
        it.graph_file = folder / "routes.geojson"
        it.graph_file.write_text(OLD)
        it.editor.start()
        it.mode.selected = "2"
        it.at((9.0, 9.0))
        it.drawing.connect()
        yield it


def sent(it: DrawnGraph) -> SendGraph:
    """Press the key, choose to send it, say yes; return the command that left."""
    it.sending.start()
    it.desk.menus[-1].choose("Send to robot_0")
    it.desk.say_yes()
    command = it.desk.backend.submitted[-1]
    assert isinstance(command, SendGraph)
    return command


def ends(it: DrawnGraph, command: SendGraph, *stages: Stage) -> str:
    """Let the command end; return what is said then."""
    store = it.desk.store
    number = len(store.state.commands) + 1
    store.apply(CommandIssued(number, command, T0, 0.0))
    for stage in stages:
        store.apply(CommandAdvanced(number, stage, T0 + 1, Message("")))
    return it.desk.notices.text


async def test_the_file_is_written_after_the_yes_with_what_the_old_one_has(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        it.sending.start()
        it.desk.menus[-1].choose("Send to robot_0")
        assert it.graph_file is not None and it.graph_file.read_text() == OLD
        it.desk.say_yes()
        (command,) = it.desk.backend.submitted
        assert isinstance(command, SendGraph) and command.path == str(it.graph_file)
        features = json.loads(it.graph_file.read_text())["features"]
        assert [one["properties"]["id"] for one in features if one["geometry"]["type"] == "Point"] == [
            1,
            2,
            3,
        ]
        assert features[0]["properties"]["note"] == 7
    assert (tmp_path / "routes.geojson.bak").read_text() == OLD
    (kept,) = (tmp_path / "graphs").iterdir()
    assert "Store" in kept.read_text()


async def test_a_loaded_file_is_the_live_graph_and_the_draft_is_the_same(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        command = sent(it)
        assert it.checks.changes(it.floor)
        ends(it, command, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
        (loaded,) = it.desk.backend.events
        assert isinstance(loaded, FloorGraphLoaded) and (loaded.floor, loaded.problem) == (F0, "")
        it.desk.store.apply(loaded)
        assert it.checks.changes(it.floor) == ()
        graph = it.desk.store.state.robots[R0].maps[F0].graph
        assert graph is not None and list(graph.vertices) == ["1", "2", "3"]


async def test_drawn_elements_have_ids_that_the_file_can_have(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        before = it.floor
        sent(it)
        assert it.floor is before
        assert it.graph_file is not None
        ids = [one["properties"]["id"] for one in json.loads(it.graph_file.read_text())["features"]]
        assert {3, 4, 5} <= set(ids) and len(set(ids)) == len(ids)


async def test_ids_that_the_file_can_not_have_are_a_step_of_the_draft(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        it.editor.do(Change(Message("as live"), edges=((None, DocumentEdge("1", "1", "3")),)))
        before = it.floor
        command = sent(it)
        assert not it.floor.edges.keys() & it.floor.vertices.keys()
        assert len(command.edges) == len(before.edges)
        it.editor.undo()
        assert (it.floor.edges, it.floor.vertices) == (before.edges, before.vertices)


@pytest.mark.parametrize(
    ("stages", "said"),
    [
        ((Stage.SENT, Stage.REFUSED), "has not loaded it"),
        ((Stage.NOT_SENT,), "has not loaded it"),
        ((Stage.SENT, Stage.NO_ANSWER, Stage.NOT_CONFIRMED), "may have loaded it or not"),
    ],
)
async def test_a_call_that_fails_leaves_the_live_graph_and_is_said_with_the_file(
    tmp_path: Path, stages: tuple[Stage, ...], said: str
) -> None:
    async with drawn(tmp_path) as it:
        text = ends(it, sent(it), *stages)
        start = f"routes.geojson is written, robot_0 {said}"
        assert text == f"{start} (before: routes.geojson.bak)"
        assert it.desk.backend.events == [] and it.checks.changes(it.floor)


async def test_the_same_file_again_keeps_the_one_before(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        text = ends(it, sent(it), Stage.SENT, Stage.REFUSED)
        assert "(before: routes.geojson.bak)" in text
        it.desk.answers.clear()
        sent(it)
    assert (tmp_path / "routes.geojson.bak").read_text() == OLD


async def test_files_that_were_not_loaded_do_not_replace_the_old_one(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        ends(it, sent(it), Stage.SENT, Stage.REFUSED)
        for at in ((2.0, 9.0), (6.0, 9.0)):
            it.at(at)
            it.drawing.connect()
            it.desk.answers.clear()
            command = sent(it)
            assert command.is_kept
        assert (tmp_path / "routes.geojson.bak").read_text() == OLD
        assert it.graph_file is not None
        loaded = it.graph_file.read_text()
        ends(it, command, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
        it.at((3.0, 3.0))
        it.drawing.connect()
        it.desk.answers.clear()
        sent(it)
    assert (tmp_path / "routes.geojson.bak").read_text() == loaded


async def test_without_a_geojson_file_it_is_refused_with_the_remedy(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        it.graph_file = None
        it.sending.start()
        assert 'set graph = "FILE.geojson" in [[floors]] of floor_0' in it.desk.notices.text[:80]
        it.graph_file = tmp_path / "routes.yaml"
        it.sending.start()
        assert "routes.yaml is native, not geojson: run fleet-tui graph convert" in it.desk.notices.text[:80]
        it.graph_file.write_text(OLD)  # by its content it is one
        it.sending.start()
        assert len(it.desk.menus) == 1


async def test_a_graph_that_the_route_server_refuses_is_not_sent(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        for edge in tuple(it.floor.edges):
            it.mode.selected, it.mode.edge = "", edge
            it.drawing.remove()
        it.sending.start()
        assert it.desk.notices.text.startswith("not sent: ") and not it.desk.menus


async def test_a_file_that_can_not_be_written_stops_it(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        it.graph_file = tmp_path / "gone" / "routes.geojson"
        it.sending.start()
        it.desk.menus[-1].choose("Send to robot_0")
        it.desk.say_yes()
        assert "gone/routes.geojson: cannot be written" in it.desk.notices.text
        assert not it.desk.backend.submitted


@two_users
async def test_a_file_that_another_user_can_write_is_not_sent(tmp_path: Path) -> None:
    async with drawn(tmp_path) as it:
        assert it.graph_file is not None
        give(it.graph_file)
        it.sending.start()
        assert it.desk.notices.text.startswith(f"not sent: {it.graph_file} is not owned by root: ")
        assert not it.desk.menus and not it.desk.backend.submitted


async def test_nothing_is_sent_with_a_configuration_that_somebody_else_could_have_written(
    tmp_path: Path,
) -> None:
    async with drawn(tmp_path) as it:
        console = it.desk.console(doubt=Message("config.toml is not owned by ana"))
        DraftSending(console, it.editor, it.checks, it.route_files).start()
        assert it.desk.notices.text == "not sent: config.toml is not owned by ana"
        assert not it.desk.menus and not it.desk.backend.submitted
