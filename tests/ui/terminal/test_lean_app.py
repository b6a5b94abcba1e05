"""The bytes that go out, played into a terminal, give the picture that Textual means to show."""

import asyncio
import random
import re
from collections.abc import Callable
from dataclasses import replace
from time import monotonic
from typing import Any

import numpy as np
import pytest
from textual.app import ComposeResult
from textual.containers import Vertical
from textual.widgets import Input, OptionList, Static

from fleet_tui.model.geometry import Line, MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, build_grid
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.terminal.lean_app import KeyAnswer, LeanApp
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.widgets.map_view import MapView
from tests.support.polling import HANGS
from tests.support.terminal import PlayedDriver, intended, paint, shown, terminal_of

SIDE = 300
STYLES = load_themes()[0]["dark"].styles()


def a_scene(robots: int = 4) -> Scene:
    classes = np.full((SIDE, SIDE), FREE, np.uint8)
    classes[0] = classes[-1] = classes[:, 0] = classes[:, -1] = OCCUPIED
    classes[100:140, 40:200:7] = OCCUPIED
    frame = MapFrame(0.05, SIDE, SIDE)
    return Scene(
        "floor_0",
        frame,
        build_grid(frame, classes),
        (
            SceneVertex("1", 2, 2, label="Base"),
            SceneVertex("2", 9, 8, label="倉庫A"),
            SceneVertex("3", 5, 12),
        ),
        ((2.0, 2.0, 9.0, 8.0), (9.0, 8.0, 5.0, 12.0)),
        tuple(
            SceneRobot(f"robot_{n}", n + 1, Pose(3.0 + n, 3.0 + n), selected=n == 0) for n in range(robots)
        ),
        one_way=((9.0, 8.0, 5.0, 12.0),),
    )


class Pane(LeanApp):
    CSS = """
    Screen { layers: base over; }
    MapView { height: 1fr; }
    Vertical { layer: over; display: none; width: 30; height: 9; border: round cyan; background: #202020; }
    Vertical.-open { display: block; }
    """

    def __init__(self) -> None:
        super().__init__(driver_class=PlayedDriver)
        self.map = MapView(STYLES)
        self.controls = MapControls(self.map)

    def compose(self) -> ComposeResult:
        yield self.map
        with Vertical():
            yield Static("Überschrift: 漢字 e\u0301 [b]bold[/b] [u]under[/u]")
            yield Input(placeholder="type")
            yield OptionList("one", "twö", "三")

    def drive(self, rng: random.Random) -> None:
        """The robots go a little further."""
        scene = self.map.picture.scene or a_scene()
        robots = tuple(_moved(robot, rng) if rng.random() < 0.3 else robot for robot in scene.robots)
        if rng.random() < 0.1:
            ways = [tuple(_line(rng) for _ in range(rng.randrange(3))) for _ in range(2)]
            mission = rng.choice([None, Mission(ways[0], ways[1], rng.choice([None, _line(rng)]))])
            targets = tuple(rng.sample(("1", "2", "3"), rng.randrange(3)))
            scene = replace(scene, mission=mission, target_vertices=targets)
        self.map.show(replace(scene, robots=robots, at=scene.at + rng.uniform(0, 3)))


def _moved(robot: SceneRobot, rng: random.Random) -> SceneRobot:
    """Somewhere else, and in any state."""
    states = ("cargo", "online", "paused", "obstacle", "other_map")
    pose = Pose(rng.uniform(0, 15), rng.uniform(0, 15), rng.uniform(0, 6))
    state: dict[str, Any] = {name: rng.random() < 0.5 for name in states}
    return robot._replace(pose=pose, age=rng.uniform(0, 9999), **state)


def _line(rng: random.Random) -> Line:
    return rng.uniform(0, 15), rng.uniform(0, 15), rng.uniform(0, 15), rng.uniform(0, 15)


def _overlay(app: Pane, _rng: random.Random) -> None:
    app.query_one(Vertical).toggle_class("-open")


def _type(app: Pane, rng: random.Random) -> None:
    app.query_one(Input).value += rng.choice(["a", "é", "漢", "e\u0301", "\t"])


def _resize(app: Pane, rng: random.Random) -> None:
    terminal_of(app).resize(rng.randrange(30, 100), rng.randrange(8, 34))


def _palette(app: Pane, _rng: random.Random) -> None:
    if len(app.screen_stack) > 1:
        app.pop_screen()
    else:
        app.action_command_palette()


STEPS: list[Callable[[Pane, random.Random], object]] = [
    *[lambda app, _rng: app.controls.zoom_in()] * 2,
    *[lambda app, _rng: app.controls.zoom_out()] * 2,
    lambda app, rng: app.controls.pan(rng.choice([-1, 1]), rng.choice([-1, 1])),
    lambda app, _rng: app.controls.labels(),
    lambda app, _rng: app.controls.edges(),
    lambda app, _rng: app.controls.trails(),
    lambda app, _rng: app.controls.follow(),
    lambda app, rng: app.controls.next_vertex(rng.choice([-1, 1])),
    lambda app, _rng: app.controls.drawing(),
    lambda app, _rng: app.controls.cursor(),
    lambda app, _rng: app.notify("a toast over 地図"),
    _overlay,
    _type,
    _resize,
    _palette,
]


@pytest.fixture(autouse=True)
def true_colour(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.setenv("COLORTERM", "truecolor")
    monkeypatch.delenv("NO_COLOR", raising=False)


def difference(app: Pane) -> list[tuple[int, int, object, object]]:
    """Cells (x, y) where the terminal shows the first and Textual means the second."""
    found, wanted = shown(terminal_of(app)), intended(app)
    assert [len(row) for row in found] == [len(row) for row in wanted]
    return [
        (x, y, cell, meant)
        for y, rows in enumerate(zip(found, wanted, strict=True))
        for x, (cell, meant) in enumerate(zip(*rows, strict=True))
        if cell != meant
    ]


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(1, 4))]
)
async def test_the_terminal_shows_what_textual_means_after_anything(seed: int) -> None:
    rng = random.Random(seed)
    app = Pane()
    async with app.run_test(headless=False, size=(80, 24), notifications=True) as pilot:
        app.map.show(a_scene())
        for step in range(50):
            rng.choice(STEPS)(app, rng)
            for _ in range(rng.randrange(24)):
                app.drive(rng)
                paint(app, app.map)
            end = monotonic() + 10.0
            while True:  # a palette or a toast may still be laid out
                await pilot.pause()
                paint(app, app.map)
                if not difference(app) or monotonic() > end:
                    break
            assert difference(app)[:9] == [], f"step {step}"


async def test_with_another_textual_the_stock_painting_takes_over(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Pane, "LEAN", False)
    app = Pane()
    async with app.run_test(headless=False) as pilot:
        app.map.show(a_scene())
        await pilot.pause()
        assert app.output.buffer is None
        assert difference(app) == []


async def test_frames_are_left_out_while_nobody_reads_and_the_newest_comes_after() -> None:
    app = Pane()
    rng = random.Random(3)
    async with app.run_test(headless=False) as pilot:
        terminal = terminal_of(app)
        unread: list[float] = []
        app.output.read_again = unread.append
        app.map.show(a_scene())
        await pilot.pause()
        assert app.output.unread_for() == 0.0
        terminal.reads = False
        for _ in range(50):
            app.drive(rng)
            paint(app, app.map)
        assert terminal.waiting.qsize() == 1 and app.output.unread_for() > 0.0 and not unread
        terminal.read_again()
        async with asyncio.timeout(HANGS):
            while difference(app):
                await pilot.pause()
        assert unread and min(unread) > 0.0 and app.output.unread_for() == 0.0


async def test_a_robot_that_moves_a_cell_costs_a_few_bytes_and_standing_still_none() -> None:
    app = Pane()
    async with app.run_test(headless=False, size=(200, 60)) as pilot:
        written = terminal_of(app).written
        scene = a_scene(1)
        app.map.show(scene)
        await pilot.pause()
        written.clear()
        paint(app, app.map)
        assert written == []
        app.map.show(replace(scene, robots=(scene.robots[0]._replace(pose=Pose(12.0, 3.0)),)))
        paint(app, app.map)
        assert 20 < len("".join(written)) < 200


async def test_a_terminal_that_was_resized_there_and_back_is_painted_anew() -> None:
    app = Pane()
    async with app.run_test(headless=False) as pilot:
        app.map.show(a_scene())
        await pilot.pause()
        terminal = terminal_of(app)
        terminal.screen.reset()  # what it showed is lost
        terminal.resize(80, 24)
        await pilot.pause()
        paint(app, app.map)
        assert difference(app) == []


async def test_without_colour_not_one_colour_leaves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    app = Pane()
    async with app.run_test(headless=False, notifications=True) as pilot:
        app.map.show(a_scene())
        app.notify("a toast")
        app.query_one(Vertical).add_class("-open")
        app.action_command_palette()
        await pilot.pause()
        sent = "".join(terminal_of(app).written)
    codes = {code for part in re.findall(r"\x1b\[([0-9;]*)m", sent) for code in part.split(";")}
    assert codes <= {"", "0", "1", "2", "3", "4", "7"}
    assert "7" in codes


async def test_a_key_has_other_work_wait_until_its_picture_is_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    noted = list[str]()
    for step in ("asked", "shown"):
        monkeypatch.setattr(KeyAnswer, step, lambda _answer, step=step: noted.append(step))
    app = Pane()
    async with app.run_test(headless=False) as pilot:
        app.map.show(a_scene())
        await pilot.pause()
        noted.clear()
        await pilot.press("x")
        assert noted[0] == "asked"
        app.controls.zoom_in()
        paint(app, app.map)
        assert noted[-1] == "shown"
