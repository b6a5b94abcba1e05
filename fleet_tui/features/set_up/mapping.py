"""Mapping: its mode on and off, the live map in words, and saving it."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from fleet_tui.config.schema import expanded
from fleet_tui.maps.saving import file_name, map_files, save_map
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.kind import MAP_SAVE, MAPPING, POSE_GRAPH_SAVE
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetMapping
from fleet_tui.model.set_up.survey import survey
from fleet_tui.orders.mode import mapping_text
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import EMPTY, Message, joined, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry, Typed
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene

WORD = "save-map"
"""First word of a typed line that saves the map."""


class MappingControls:
    """Lists what can be done about the map of the selected robot's floor; says how it grows."""

    def __init__(self, console: Console, picture: MapPicture) -> None:
        self._console = console
        self._picture = picture
        self._files = console.files
        self._ask = console.ask
        self._in_background = console.in_background
        self._say_from_thread = console.say_from_thread
        self._grid: OccupancyGrid | None = None
        self._text = EMPTY

    @property
    def _robot(self) -> Robot:
        return self._console.store.state.robots[self._console.navigation.robot]

    def on(self, scene: Scene) -> Scene:
        """Return the scene with a note on the map that grows, while the selected robot maps."""
        mapping = mapping_text(self._robot)
        if not mapping or scene.grid is None:
            return scene
        note = f"{mapping}, {self.map_text(scene.grid)}"
        return scene.with_note(note) if not scene.note else scene

    def map_text(self, grid: OccupancyGrid) -> str:
        """Return the known area of a map, and its age."""
        if grid is not self._grid:
            self._grid = grid
            self._text = Message("{known} m2 known", known=f"{survey(grid).known:.0f}")
        state, floor = self._console.store.state, self._console.navigation.floor
        robot_map = self._robot.maps.get(floor)
        at = (robot_map.grid_at if robot_map is not None else None) or state.floors[floor].live_at
        return (
            Message("{text}, map {age} old", text=self._text, age=age(max(0.0, state.now - at)))
            if at is not None
            else self._text
        )

    def menu(self) -> None:
        """List the actions: mapping on or off, saving the map."""
        robot, scene = self._robot, self._picture.scene
        entries: list[Entry] = []
        refusal = self._console.dispatch.permissions.refusal(Right.SETUP)
        if refusal:
            self._console.notices.note(refusal)
        elif robot.kind.can(MAPPING):
            entries += [
                (Message("Mapping {mode}", mode=mode), partial(self._switch, mode == "on"))
                for mode in ("on", "off")
            ]
        else:
            self._console.notices.note(robot.kind.lack(MAPPING))
        mapping = mapping_text(robot) or Message("not mapping, as far as is known")
        lines = [Message("{robot}: {mapping}", robot=robot.name, mapping=mapping)]
        if scene is not None and scene.grid is not None:
            lines.append(Message("{floor}: {map}", floor=scene.floor, map=survey(scene.grid).text))
            entries.append(
                (
                    Message("Save this map to a file"),
                    partial(self._console.begin, f"{WORD} {file_name(scene.floor)}.yaml"),
                )
            )
        else:
            lines.append(Message("no map yet"))
        named = (
            (MAP_SAVE, "store-map", Message("map")),
            (POSE_GRAPH_SAVE, "store-pose-graph", Message("pose graph")),
        )
        for ability, verb, what in named:
            if robot.kind.can(ability) and not refusal:
                line = f"{verb} {robot.name} {robot.floor or ''}"
                entries.append(
                    (Message("Store the {what} on the robot", what=what), partial(self._console.begin, line))
                )
        self._console.open_menu(
            joined("\n", map(sanitize, lines)), entries or [(Message("No action available"), lambda: None)]
        )

    def _switch(self, on: bool) -> None:
        self._console.dispatch.do(Request((SetMapping(self._robot.name, on),)))

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as a file to save the map to, None for any other."""
        word, _, name = line.strip().partition(" ")
        if word != WORD:
            return None
        scene = self._picture.scene
        if scene is None or scene.grid is None:
            return Typed(problem=Message("no map is shown"))
        if self._files.naming_refusal:
            return Typed(problem=self._files.naming_refusal)
        if not name.strip():
            return Typed(
                problem=Message("a file: {command} maps/{floor}.yaml", command=WORD, floor=scene.floor)
            )
        return Typed(
            [
                (
                    Message("Save the map to {file}", file=sanitize(name.strip())),
                    partial(self._save, scene.grid, name.strip()),
                )
            ]
        )

    def _save(self, grid: OccupancyGrid, name: str) -> None:
        if refusal := self._console.dispatch.set_up_refusal():
            self._console.notices.say(refusal)
            return
        path = expanded(name)
        save = partial(self._in_background, partial(_saved, grid, path, self._say_from_thread), self._said)
        try:
            exists = any(file.exists() for file in map_files(path))
        except (OSError, ValueError) as problem:
            self._console.notices.say(
                sanitize(Message("map not saved: {name}: {problem}", name=name, problem=problem))
            )
            return
        if exists:
            self._ask(lambda: Message("{name} exists: it is kept as .bak. Save?", name=sanitize(name)), save)
        else:
            save()

    def _said(self, text: Any) -> None:
        self._files.log("map saved", str(text))
        self._console.notices.say(sanitize(message_of(text)))


def _saved(grid: OccupancyGrid, path: Path, report: Callable[[Message], None]) -> str:
    """Save a map, and return the result in words."""
    try:
        yaml = save_map(grid, path, report)
    except MapError as problem:
        return Message("map not saved: {problem}", problem=problem)
    return Message("map saved to {yaml}, read back and compared: {text}", yaml=yaml, text=survey(grid).text)
