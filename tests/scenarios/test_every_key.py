"""Every key of the help has its effect, each in a console of its own mode."""

import time
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.console.app import FleetApp
from fleet_tui.keys import Pane
from fleet_tui.model.history.facts import Activity, Span
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.console_pilot import Console, console
from tests.support.key_effects import Presses, close_all, focus, overlays
from tests.support.nav2_site import nav2_site
from tests.support.past import kept_history, put
from tests.support.replay_console import replayed
from tests.support.scenario import plant
from tests.support.shift import shift as past_shift
from tests.support.tapes import shift
from tests.support.watched_store import config_of

pytestmark = pytest.mark.nightly

ROBOTS = 9
EVERYWHERE = {
    **dict.fromkeys(("help", "help_anywhere", "palette", "order", "why", "robot_page"), "overlay"),
    **dict.fromkeys(
        ("cancel", "clear", "resume_all", "diagnostics", "audit", "history", "programs", "routines"),
        "overlay",
    ),
    **dict.fromkeys(("pause", "resume", "pause_all", "pause_all_anywhere"), "sent"),
    **{f"{step}_robot{plain}": "robot" for step in ("next", "previous") for plain in ("", "_plain")},
    **{f"{step}_floor{plain}": "floor" for step in ("next", "previous") for plain in ("", "_plain")},
    **{f"robot_{number}": "robot" for number in range(1, ROBOTS)},
    "robot_9": "notice",
    **dict.fromkeys(("suspend", "repaint", "quit"), "called"),
    **dict.fromkeys(("back", "next_pane", "previous_pane"), "focus"),
    "next_trouble": "robot",
    "acknowledge": "alarms",
    "acknowledge_all": "alarms",
    "bundle": "notice",
    "say_quit": "notice",
    "charge": "notice",
    "facilities": "notice",
    **dict.fromkeys(("edit", "drive", "pose", "goal", "mapping", "laser", "path", "camera"), "answer"),
    "filter_rows": "overlay",
    "sort_rows": "sorted",
    "group_rows": "grouped",
    "mark_row": "marked",
    "copy_row": "notice",
    "all_orders": "queue",
    "enlarge": "enlarged",
    "simple": "simple",
}
ON_THE_MAP = {
    **dict.fromkeys(("zoom_in", "zoom_out", "fit", "centre"), "view"),
    **{f"pan_{way}": "view" for way in ("left", "right", "up", "down")},
    **dict.fromkeys(("edges", "labels", "trails", "drawing"), "options"),
    **dict.fromkeys(("map_cursor", "next_vertex", "previous_vertex"), "options"),
    "zoom_about": "zoom",
    "follow": "follow",
    "pick": "overlay",
}
IN_TABLES = {
    **dict.fromkeys(("row_up", "row_down", "page_up", "page_down", "first_row", "last_row"), "row"),
    **dict.fromkeys(("column_left", "column_right"), "slid"),
    "menu": "overlay",
}
FIRST: dict[str, tuple[str, ...]] = {
    "back": ("tab",),
    "fit": ("+",),
    "zoom_out": ("0", "+"),
    **{f"pan_{way}": ("0", "+", "+") for way in ("left", "right", "up", "down")},
    "centre": ("0", "+", "+", "left"),
    "row_up": ("down",),
    "page_up": ("down",),
    "first_row": ("down",),
    "column_left": ("right",),
}
IN_THE_EDITOR = (
    *(
        "add",
        "connect",
        "select",
        "name",
        "type",
        "turn",
        "move",
        "remove",
        "undo",
        "redo",
        "lint",
        "compare",
    ),
    *("write", "send", "add_at_robot", "leave", "left_far", "right_far", "up_far", "down_far"),
)
DRIVING = {
    **dict.fromkeys(("ahead", "back", "left", "right", "sideways_left", "sideways_right"), "moves"),
    "faster": "view",
    "slower": "view",
    "leave": "mode",
}
IN_A_RECORDING = (
    *("play", "skip_back", "skip_on", "previous_mark", "next_mark", "step_back", "step_on", "record_back"),
    *("record_on", "faster", "slower", "usual_speed", "go_to_time", "to_beginning", "to_the_end"),
)
OF_DIAGNOSTICS = (
    *(f"page_{name}" for name in ("link", "topics", "raw", "log", "health", "console")),
    *("next_page", "previous_page", "filter", "freeze", "copy", "level", "bad", "leave"),
)


OF_HISTORY = tuple(
    f"history_{name}"
    for name in (
        *("events", "robots", "batteries", "alarms", "places", "next_page", "previous_page", "filter"),
        *("earlier", "later", "longer", "shorter", "floor", "replay", "leave"),
    )
)


async def test_every_key_of_the_console_the_map_and_the_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[str] = []
    for name in ("exit", "action_suspend_process", "action_repaint"):
        monkeypatch.setattr(FleetApp, name, lambda _app, *_, name=name: called.append(name))
    server = RosbridgeServer(OhFleet(robots=ROBOTS, floors=2, seed=1, quiet=True))
    await server.start()
    plant(server, "battery:robot_1,battery:robot_2")
    try:
        async with console(config_of(server.url, ROBOTS, 2)) as it:
            await it.press("colon")
            await it.type("robot_0 Base > Store")
            await it.press("enter")
            await it.until(lambda state: state.robots["robot_0"].orders.open and state.unacknowledged == 2)
            presses = Presses(it, _to_the_map, {"called": lambda _: len(called)})
            await presses.each((Pane.CONSOLE, Pane.ANYWHERE, Pane.MAP), {**EVERYWHERE, **ON_THE_MAP}, FIRST)
            await Presses(it, _to_the_fleet).each((Pane.ROWS,), IN_TABLES, FIRST)
    finally:
        await server.stop()


async def _to_the_map(it: Console) -> None:
    """With nothing under way: a pause is known by then."""
    await close_all(it)
    panes, picture = it.app.main.panes, it.app.main.features.map.picture
    on = {"=": panes.is_enlarged, "s": panes.has_class("-simple"), "g": picture.options.cursor is not None}
    await it.press(*(key for key, is_on in on.items() if is_on))
    it.app.main.navigation.find_robot("robot_0")
    await it.until(lambda state: all(one.is_decided for one in state.commands))


async def _to_the_fleet(it: Console) -> None:
    await _to_the_map(it)
    it.app.main.set_focus(it.app.main.fleet)


async def test_every_key_of_diagnostics(server: RosbridgeServer) -> None:
    async def opened(it: Console) -> None:
        if "diagnostics" not in overlays(it):
            await it.press("d")
        await it.press("2" if focus(it) == "diagnostics-rows" else "escape")

    first = {"page_topics": ("1",), "freeze": ("3",), "level": ("4",), "bad": ("3",)}
    async with console(config_of(server.url, 2, 2)) as it:
        effects = dict.fromkeys(OF_DIAGNOSTICS, "diagnostics")
        await Presses(it, opened).each((Pane.DIAGNOSTICS,), effects, first)


async def test_every_key_of_the_history(server: RosbridgeServer, tmp_path: Path) -> None:
    async def opened(it: Console) -> None:
        if "history" not in overlays(it):
            await it.press("H")
        await it.press("1" if focus(it) == "history-rows" else "escape")
        while "to now" not in it.pane("history-pages"):
            await it.press(".")
        await it.shows("robot_0 order 1", "history-rows")

    began = time.time() - 3600
    upstairs = Span("robot_1", Activity.BLOCKED, began, began + 100, "floor_1", 5.0, 5.0)
    put(tmp_path, [*past_shift(began), upstairs])
    files = ConsoleFiles()
    first = {
        "history_events": ("2",),
        "history_shorter": ("-", "-"),
        "history_later": (",",),
        "history_floor": ("5",),
    }
    with kept_history(tmp_path) as files.history:
        async with console(config_of(server.url, 2, 2), files=files) as it:
            await Presses(it, opened).each((Pane.HISTORY,), dict.fromkeys(OF_HISTORY, "history"), first)


async def test_every_key_of_the_graph_editor(server: RosbridgeServer) -> None:
    async def editing(it: Console) -> None:
        await close_all(it)
        if not it.app.main.features.editing.editor.is_open:
            await it.press("E")
            if overlays(it):
                await it.press("enter")

    on_vertex = dict.fromkeys(("connect", "select", "name", "type", "move", "remove", "undo"), ("right", "i"))
    more = {"connect": ("right", "i", "L"), "redo": ("right", "i", "u"), "turn": ("right", "i", "L", "e")}
    first = {f"edit_{name}": keys for name, keys in {**on_vertex, **more}.items()}
    async with console(config_of(server.url, 2, 2)) as it:
        await Presses(it, editing).each(
            (Pane.EDIT,), {f"edit_{name}": "draft" for name in IN_THE_EDITOR}, first
        )


async def test_every_key_of_a_pose(tmp_path: Path) -> None:
    async def placing(it: Console) -> None:
        await close_all(it)
        if it.app.main.features.set_up.poses.mode is None:
            await it.press("I")

    names = ("send", "left", "right", "fine_left", "fine_right", "snap", "leave")
    async with nav2_site(tmp_path, rate=10.0) as site, console(site.config) as it:
        await it.until(lambda state: state.robots["robot_0"].still_for > 1)
        await Presses(it, placing).each((Pane.PLACE,), {f"place_{name}": "place" for name in names}, {})


async def test_every_key_of_a_drive(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0, rate=20.0) as site:

        def twists() -> list[bool]:
            """Return of each twist that the bridge received whether it moves the robot."""
            of_robot = [one for one in site.server.bridge.received if one.get("topic") == "/robot_0/cmd_vel"]
            sent = [one["msg"] for one in of_robot if one["op"] == "publish"]
            return [any(value for part in one.values() for value in part.values()) for one in sent]

        async def standing(it: Console) -> None:
            await close_all(it)
            if it.app.main.features.driving.controls.mode is None:
                await it.press("T")
                await it.shows("DRIVE robot_0 0.00 m/s", "map")
            await it.until(lambda _: not any(twists()[-1:]))

        drive = replace(site.config.drive, robot_timeout=0.5, holonomic=True)
        async with console(replace(site.config, drive=drive)) as it:
            effects = {f"drive_{name}": part for name, part in DRIVING.items()}
            first = {"drive_faster": ("-",)}
            presses = Presses(it, standing, {"moves": lambda _: sum(twists())})
            await presses.each((Pane.DRIVE,), effects, first)


async def test_every_key_of_a_recording(tmp_path: Path) -> None:
    async def in_the_middle(it: Console) -> None:
        await close_all(it)
        if "stopped" not in it.pane("time-line"):
            await it.press("space")
        await it.press("colon")
        await it.type("+2m5s")
        await it.press("enter")

    async with replayed(shift(tmp_path / "night.jsonl.gz").path, "+125s") as it:
        effects = dict.fromkeys(IN_A_RECORDING, "time")
        await Presses(it, in_the_middle).each((Pane.RECORDING,), effects, {"usual_speed": ("F", "F", "F")})
