"""Lines of the command palette: every action of the keys table, "go to" for everything with a name,
themes."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from fleet_tui.controllers.dispatch import Dispatch
from fleet_tui.controllers.navigation import Navigation
from fleet_tui.controllers.save import SaveCommand
from fleet_tui.controllers.session import ConsoleSession
from fleet_tui.controllers.typed import Entry, Typed, typed
from fleet_tui.keys import KEYS, Key, Pane
from fleet_tui.rules.language.grammar import parse
from fleet_tui.state.store import Store
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.hints import hidden_keys


class Offers:
    """Lists the possible actions, and parses typed text; `run` runs the action of a key."""

    def __init__(
        self,
        store: Store,
        dispatch: Dispatch,
        navigation: Navigation,
        session: ConsoleSession,
        save: SaveCommand,
        themes: Mapping[str, Callable[[], None]],
        run: Callable[[Key[Any]], object],
    ) -> None:
        self._store, self._dispatch, self._navigation = store, dispatch, navigation
        self._session, self._save, self._themes, self._run = session, save, themes, run

    def entries(self) -> Iterator[Entry]:
        """Return every entry of the palette."""
        state, navigation = self._store.state, self._navigation
        hidden = hidden_keys(state, navigation.robot)
        for key in KEYS:
            if key.in_palette and key.pane in (*self._session.panes, Pane.ANYWHERE) and key.id not in hidden:
                yield key.text, partial(self._run, key)
        if "resume" not in hidden:
            # It has no key of its own: it is rarely wanted in a hurry.
            yield (
                "Resume all robots",
                partial(self._dispatch.do, parse("resume all", state, navigation.robot)),
            )
        for name in state.robots:
            yield f"Go to robot {name}", partial(navigation.find_robot, name)
        for floor in state.floors:
            yield f"Go to floor {floor}", partial(navigation.find_floor, floor)
        yield from self._vertices()
        for name, use in self._themes.items():
            yield f"Theme: {sanitize(name)}", use

    def _vertices(self) -> Iterator[Entry]:
        robot = self._store.state.robots[self._navigation.robot]
        for floor, robot_map in robot.maps.items():
            for id_, label in robot_map.labels.items():
                vertex = robot_map.graph.vertices.get(id_) if robot_map.graph else None
                if vertex is not None:
                    find = partial(self._navigation.find_vertex, floor, vertex.x, vertex.y)
                    yield f"Go to vertex {sanitize(label)}", find

    def typed(self, line: str) -> Typed:
        """Parse a typed line: a time, a file to save to, else a command."""
        return (
            self._session.typed(line)
            or self._save.typed(line)
            or typed(line, self._store.state, self._navigation.robot, self._dispatch.do)
        )
