"""Lines of the command palette: every action of the keys table, "go to" for everything with a name,
themes."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from fleet_tui.keys import KEYS, Key, Pane, outdone
from fleet_tui.keys.key import key_name
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.sites import robots_at, sites_of
from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.save import SaveCommand
from fleet_tui.ui.controllers.session import ConsoleSession
from fleet_tui.ui.controllers.typed import Typed, typed
from fleet_tui.ui.view.help.synonyms import SYNONYMS
from fleet_tui.ui.view.lines.hints import hidden_keys, unoffered_keys

WORD = "site"


def typed_site(line: str, state: FleetState, find: Callable[[str], None]) -> Typed | None:
    """Parse a typed line as a site to show, None if it is not one. `find` selects its first robot."""
    word, _, name = line.strip().partition(" ")
    if word.casefold() != WORD:
        return None
    sites = [site for site in sites_of(state) if site]
    name = name.strip()
    if not sites:
        return Typed(problem=Message("this console has one site: give links a site in the configuration"))
    if name not in sites:
        near = [f"{WORD} {site}" for site in sites if site.startswith(name)]
        problem = (
            Message(
                "no site {name}{did_you_mean}", name=sanitize(name), did_you_mean=did_you_mean(name, sites)
            )
            if name and not near
            else EMPTY
        )
        return Typed(
            completed=near, problem=problem or Message("site NAME: {sites}", sites=sanitize(", ".join(sites)))
        )
    robots = robots_at(state, name)
    if not robots:
        return Typed(problem=Message("site {name} has no robots", name=sanitize(name)))
    return Typed([(Message("Go to site {name}", name=sanitize(name)), partial(find, robots[0]))])


class Offer(NamedTuple):
    """A line of the palette and its action; the key that has it, too, the name that it goes to, and other
    words that find it."""

    text: str
    do: Callable[[], object]
    key: str = ""
    name: str = ""
    also: str = ""


class Offers:
    """Lists the possible actions, and parses typed text; `run` runs the action of a key."""

    def __init__(
        self, console: Console, session: ConsoleSession, save: SaveCommand, run: Callable[[Key], object]
    ) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._navigation = console.navigation
        self._session = session
        self._save = save
        self._settings = console.settings
        self._run = run

    def entries(self) -> Iterator[Offer]:
        """Return every entry of the palette."""
        state, navigation = self._store.state, self._navigation
        hidden = hidden_keys(state, navigation.robot)
        hidden |= unoffered_keys(self._session.offers, self._dispatch.permissions.right)
        hidden |= outdone(self._settings.keys, hidden)
        for key in KEYS:
            if key.in_palette and key.pane in (*self._session.panes, Pane.ANYWHERE) and key.id not in hidden:
                shown = "".join(map(key_name, self._settings.keys[key.id][:1]))
                yield Offer(
                    translate(key.text),
                    partial(self._run, key),
                    shown,
                    also=f"{key.text} {SYNONYMS.get(key.id, '')}",
                )
        for name in state.robots:
            yield Offer(tr("Go to robot {name}", name=name), partial(navigation.find_robot, name), name=name)
        for floor in state.floors:
            yield Offer(
                tr("Go to floor {floor}", floor=floor), partial(navigation.find_floor, floor), name=floor
            )
        for site in filter(None, sites_of(state)):
            for first in robots_at(state, site)[:1]:
                yield Offer(
                    tr("Go to site {site}", site=sanitize(site)),
                    partial(navigation.find_robot, first),
                    name=site,
                )
        yield from self._vertices()
        for name, use in self._settings.themes.items():
            yield Offer(tr("Theme: {name}", name=sanitize(name)), use)

    def _vertices(self) -> Iterator[Offer]:
        robot = self._store.state.robots[self._navigation.robot]
        for floor, robot_map in robot.maps.items():
            for id_, label in robot_map.labels.items():
                vertex = robot_map.graph.vertices.get(id_) if robot_map.graph else None
                if vertex is not None:
                    find = partial(self._navigation.find_vertex, floor, vertex.x, vertex.y)
                    yield Offer(tr("Go to vertex {label}", label=sanitize(label)), find, name=label)

    def typed(self, line: str) -> Typed:
        """Parse a typed line: a time, a file to save to, else a command."""
        robot = self._navigation.robot
        return (
            self._session.typed(line)
            or self._save.typed(line)
            or typed_site(line, self._store.state, self._navigation.find_robot)
            or typed(line, self._store.state, robot, self._dispatch.do, self._dispatch.permissions)
        )
