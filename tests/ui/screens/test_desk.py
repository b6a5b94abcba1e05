"""The desk on the screen: two consoles, one of them with a screen."""

import time
from pathlib import Path

from fleet_tui.features.desk.notes import join_desk
from fleet_tui.model.desk.events import RobotClaimed
from fleet_tui.model.history.facts import Note
from fleet_tui.records.desk.desk import SharedDesk
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.console_pilot import Console
from tests.support.past import kept_history
from tests.support.planted_console import planted
from tests.support.shared_desk import at_desk


def join(it: Console, folder: Path, files: ConsoleFiles) -> None:
    """Let the console take part in the desk, as `fleet-tui` does."""
    links = it.app.main.backend
    assert files.desk is None
    files.desk = SharedDesk(folder, it.store, "ana")
    join_desk(it.app.main.console_parts, it.app.main.call_later)
    files.desk.start(links.post)


async def test_a_claim_stands_in_the_row_and_is_asked_about(tmp_path: Path) -> None:
    files = ConsoleFiles()
    with kept_history(tmp_path) as history, at_desk(tmp_path, "ben") as (ben,):
        files.history = history
        async with planted(2, files=files) as it:
            join(it, tmp_path, files)
            ben.post(RobotClaimed("robot_0"))
            await it.shows("claimed by ben", "fleet")
            await it.press("r")
            await it.shows("robot_0 is claimed by ben")
            await it.press("n", ":")
            await it.type("claim robot_1")
            await it.press("enter")
            await it.shows("claimed by ana", "fleet")
            ben.becomes(lambda state: state.desk.other_holders("robot_1") == ["ana"])
            ben.becomes(lambda state: state.desk.others[0].robot == "robot_0")
            ben.desk.share_note(Note(time.time(), "ben", "lift B is slow"))
            await it.shows("note of ben: lift B is slow")
            before = time.time() - 3600
            ben.desk.share_note(Note(before, "ben", "lift B stands"))  # it waited for the folder
            await it.shows(f"note of ben, {it.app.main.settings.clock(before)}: lift B stands")
            await it.press(":")
            await it.type("note robot_1 squeaks")
            await it.press("enter")
            await it.until(lambda _: ben.notes)
            assert ben.notes[0][0].text == "robot_1 squeaks" and ben.notes[0][0].operator == "ana"
            assert files.desk is not None
            files.desk.close()


async def test_a_closed_edge_is_crossed_out_on_the_map() -> None:
    async with planted() as it:
        robot = it.store.state.robots["robot_0"]
        graph = robot.maps["floor_0"].graph
        assert graph is not None
        edge = graph.edges[0]
        await it.press(":")
        await it.type(f"close id={edge.start} id={edge.end}")
        await it.shows("cuts the way of")
        await it.press("enter")
        await it.shows("✕", "map")
        await it.press("w")
        await it.shows("Closed by this console:")
