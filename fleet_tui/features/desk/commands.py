"""The typed lines of the desk: `claim`, `release`, `close`, `open`, `desk`."""

import time
from collections.abc import Iterator
from functools import partial

from fleet_tui.commands.language.edges import edge_named, edge_text
from fleet_tui.commands.language.words import find_robot, tokens
from fleet_tui.commands.routes.impact import closed_edge_at, cut_orders
from fleet_tui.model.desk.desk import Ends
from fleet_tui.model.desk.events import EdgeClosed, EdgeOpened, RobotClaimed, RobotReleased
from fleet_tui.model.events import Event
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, joined, message_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry, Typed
from fleet_tui.ui.view.lines.impact import impact_lines, impact_text

USAGE = {
    "claim": "claim ROBOT",
    "release": "release ROBOT",
    "close": "close A B: an edge of the floor shown",
    "open": "open A B: a closed edge of the floor shown",
    "desk": "desk",
}


class DeskCommands:
    """Claims robots and closes edges; without a desk, edges are closed on this console alone."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._files = console.files
        self._post = console.backend.post
        self._clock = console.settings.clock

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line, None if it is not about the desk."""
        verb, *words = [token.text for token in tokens(line)] or [""]
        verb = verb.casefold()
        if verb not in USAGE:
            return None
        if refusal := self._console.dispatch.desk_refusal() if verb != "desk" else EMPTY:
            return Typed(problem=refusal)
        try:
            return Typed([self._entry(verb, words)], self._completed(verb, words))
        except CommandError as problem:
            return Typed(completed=self._completed(verb, words), problem=sanitize(message_of(problem)))

    def _entry(self, verb: str, words: list[str]) -> Entry:
        match verb, words:
            case "claim", [word]:
                return self._claim(word)
            case "release", [word]:
                return self._release(word)
            case "close", [start, end]:
                return self._close(self._edge(start, end))
            case "open", [start, end]:
                return self._open(self._edge(start, end))
            case "desk", []:
                return Message("Desk: consoles, claims, closed edges"), self.menu
        raise CommandError(Message("usage: {usage}", usage=USAGE[verb]))

    def _completed(self, verb: str, words: list[str]) -> list[str]:
        state, typed = self._console.store.state, words[-1] if words else ""
        match verb:
            case "claim":
                found = [f"claim {name}" for name in state.robots if name not in state.desk.claims]
            case "release":
                found = [f"release {name}" for name in state.desk.claims]
            case "open":
                closed = state.desk.closed_on(self._console.navigation.floor)
                found = [f"open {edge_text(self._robot, edge.ends, ' ')}" for edge in closed]
            case _:
                found = []
        return [one for one in found if typed in one]

    @property
    def _robot(self) -> Robot:
        return self._console.store.state.robots[self._console.navigation.robot]

    def _edge(self, start: str, end: str) -> Ends:
        return edge_named(self._robot, self._console.navigation.floor, start, end)

    def _claim(self, word: str) -> Entry:
        state = self._console.store.state
        robot = find_robot(word, state).name
        if not state.desk.me:
            raise CommandError(Message("no desk: set [desk] folder in the configuration"))
        if names := state.desk.other_holders(robot):
            raise CommandError(
                Message(
                    "{robot} is claimed by {names}: ask for its release",
                    robot=robot,
                    names=" and ".join(names),
                )
            )
        return Message("Claim {robot}: others are asked before they command it", robot=robot), partial(
            self._do, RobotClaimed(robot), "claimed", Message("claimed {robot}", robot=robot)
        )

    def _release(self, word: str) -> Entry:
        state = self._console.store.state
        robot = find_robot(word, state).name
        if robot not in state.desk.claims:
            raise CommandError(Message("{robot} is not claimed by this console", robot=robot))
        return Message("Release {robot}", robot=robot), partial(
            self._do, RobotReleased(robot), "released", Message("released {robot}", robot=robot)
        )

    def _close(self, ends: Ends) -> Entry:
        named = edge_text(self._robot, ends)
        impact = impact_text(cut_orders(self._console.store.state, ends))
        done = Message("closed {named}: {impact}", named=named, impact=impact)
        if not self._files.desk:
            done += Message(", not shared: no desk")
        return Message("Close {named}: {impact}", named=named, impact=impact), partial(
            self._do, EdgeClosed(ends, time.time()), "edge closed", done
        )

    def _open(self, ends: Ends) -> Entry:
        named = edge_text(self._robot, ends)
        if all(edge.ends != ends for edge in self._console.store.state.desk.closed):
            raise CommandError(Message("{named} is not closed", named=named))
        return Message("Open {named}", named=named), partial(
            self._do, EdgeOpened(ends), "edge opened", Message("opened {named}", named=named)
        )

    def _do(self, event: Event, change: str, done: Message) -> None:
        """Apply a change, and write it to the audit log."""
        if problem := self._post(event):
            self._console.notices.say(problem)
            return
        self._files.log(change, done)
        self._console.notices.say(sanitize(done))

    def explain_edge(self, at: tuple[float, float]) -> bool:
        """List the orders that a closed edge at a place of the map cuts, and offer to open it; tell whether
        there is one."""
        state, robot, floor = self._console.store.state, self._robot, self._console.navigation.floor
        graph = robot.maps[floor].graph if floor in robot.maps else None
        edge = closed_edge_at(state.desk.closed_on(floor), graph, at) if graph is not None else None
        if edge is None:
            return False
        cut = cut_orders(state, edge.ends)
        head = Message("{edge}: {impact}", edge=edge_text(robot, edge.ends), impact=impact_text(cut))
        lines = [head, *impact_lines(state, cut)]
        entries: list[Entry] = [] if self._console.dispatch.desk_refusal() else [self._open(edge.ends)]
        self._console.open_menu(
            joined("\n", map(sanitize, lines)), [*entries, (Message("Close this"), lambda: None)]
        )
        return True

    def menu(self) -> None:
        """List who is at the desk, with the way to what each looks at, and closed edges."""
        desk = self._console.store.state.desk
        if not desk.me and not desk.closed:
            self._console.notices.say(Message("no desk: set [desk] folder in the configuration"))
            return
        mine = Message("{me} (this console){claims}", me=desk.me, claims=_claims(desk.claims))
        title = Message("Desk: {mine}", mine=sanitize(mine) if desk.me else Message("none"))
        if not desk.others and desk.me:
            title += "\n" + Message("no other console")
        for edge in desk.closed:
            named = Message(
                "{edge_text} on {ends}", edge_text=edge_text(self._robot, edge.ends), ends=edge.ends[0]
            )
            by = edge.by or Message("this console")
            closed = Message(
                "closed {time} by {by}: {named}", time=self._clock(edge.wall), by=by, named=named
            )
            title += "\n" + sanitize(closed)
        self._console.open_menu(title, list(self._entries()), searched=True)

    def _entries(self) -> Iterator[Entry]:
        state, find = self._console.store.state, self._console.navigation.find_robot
        for one in state.desk.others:
            looks = Message(" looks at {robot}", robot=one.robot) if one.robot in state.robots else EMPTY
            there = Message(
                "{name}, console on {host}{looks}{claims}",
                name=one.name,
                host=one.host,
                looks=looks,
                claims=_claims(one.claims),
            )
            yield sanitize(there), partial(find, one.robot) if looks else (lambda: None)
        if not state.desk.others:
            yield Message("Close"), lambda: None


def _claims(robots: tuple[str, ...]) -> Message:
    return Message(", claims {robots}", robots=", ".join(robots)) if robots else EMPTY
