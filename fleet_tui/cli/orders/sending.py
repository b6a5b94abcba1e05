"""From a request to the outcome of each of its commands: checked, sent, awaited."""

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

from fleet_tui.cli.orders.driving import follow_order
from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE, USAGE, Outcome, ended, unsent
from fleet_tui.cli.session import WaitingStore
from fleet_tui.commands.abilities import unaccepted
from fleet_tui.commands.checks import acceptable, problems
from fleet_tui.commands.set_up.losses import set_up_losses
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.commands import (
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.problem import Permissions, Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import CancelGoal, SetUpCommand
from fleet_tui.orders.local_queue import clearable
from fleet_tui.text.language import Message, counted, joined

LINK_WITHIN = 5.0
"""Maximum seconds to wait for a link and for a robot's reports."""

HANDOVER = 2.0
"""Maximum seconds until the link has sent a command, or refused it: later ones are refused."""

CODES = {
    "no link": NO_LINK,
    "unknown vertex": USAGE,
    "unattended": USAGE,
    "no place": USAGE,
    "no name": USAGE,
}


def losses(state: FleetState, request: Request) -> Iterator[Problem]:
    """Return the losses that the console asks about."""
    for command in request.commands:
        robot = state.robots.get(command.robot)
        if isinstance(command, ClearOrders) and robot is not None and (count := len(clearable(state, robot))):
            text = counted(
                "{name} would lose {count} order", "{name} would lose {count} orders", count, name=robot.name
            )
            yield Problem("losses", text, blocks=False)
        elif isinstance(command, CancelGoal):  # like an order's cancel, it loses nothing else
            continue
        elif isinstance(command, SetUpCommand) and robot is not None:
            lines = list(set_up_losses(state, robot, command))
            # The command is named before it, where the console asks a question.
            yield from [Problem("losses", joined(", ", lines[1:] or lines), blocks=False)] if lines else []


def unattended(state: FleetState, request: Request) -> Iterator[Problem]:
    """Return the orders whose later stops would not be sent once this command has ended."""
    for command in request.commands:
        robot = state.robots.get(command.robot)
        if isinstance(command, PlaceOrder) and robot and robot.kind.gives_stops and len(command.stops) > 1:
            text = Message(
                "{name} takes one stop at a time: use --until-done to send the others", name=robot.name
            )
            yield Problem("unattended", text)


@dataclass(frozen=True, slots=True)
class How:
    """Options for commands. `timeout`: maximum seconds to wait for all results of a line; `yes`: warnings
    don't hold it back; `until_done`: an order is done when it was driven."""

    permissions: Permissions
    timeout: float
    yes: bool = False
    until_done: bool = False


def unreported(robot: Robot) -> list[str]:
    """Return the missing reports that an order or a cancel is checked and confirmed against."""
    kind = robot.kind
    if kind.optional:  # its state has all of them, as far as it has them
        return [] if robot.vehicle is not None else ["state"]
    values: dict[str, object] = {
        name: getattr(robot, name) for name in ("queue", "cargo") if kind.expects(name)
    }
    if kind.keeps_goals:  # after its first sign of life its goals are known
        values["pose"] = robot.pose
    if kind.expects("graph"):
        values |= {f"graph of {floor}": robot_map.graph for floor, robot_map in robot.maps.items()}
    return [name for name, value in values.items() if value is None]


def reaches(state: FleetState, robot: Robot) -> bool:
    """Tell whether commands to a robot are known to get through."""
    link = state.links[robot.link]
    return link.phase is Phase.UP and link.command_path in (CommandPath.ALIVE, CommandPath.UNREGISTERED)


def divide(state: FleetState, request: Request) -> tuple[Request, list[Outcome]]:
    """Return the part of a request that the robots' kinds accept, and the outcomes of the rest."""
    able = acceptable(state, request)[0]
    return able, _unable(state, (one for one in request.commands if one not in able.commands))


def _unable(state: FleetState, commands: Iterable[Command]) -> list[Outcome]:
    return [unsent(state, command, unaccepted(state, command), NOT_DONE) for command in commands]


class Sending:
    """Sends commands on a session, and keeps the record of each: the state drops old ones."""

    def __init__(self, link: FleetLink, store: WaitingStore, how: How) -> None:
        self.link = link
        self.store = store
        self._how = how
        self._records: dict[int, CommandRecord] = {}
        self._driven: dict[int, Outcome] = {}
        self.log: Callable[[str, str], None] = lambda _change, _words: None
        """Writes an event of this command line to the audit log."""
        store.watchers.append(self._keep)
        if how.until_done:  # often only the log of a robot tells why it did not drive an order
            link.subscribe_logs(True)
        self.begin()

    def begin(self) -> None:
        """Start the time limit of a line."""
        self._deadline = time.monotonic() + self._how.timeout

    def _keep(self, before: FleetState, after: FleetState) -> None:
        self._records.update((record.id, record) for record in after.commands)

    @property
    def state(self) -> FleetState:
        """Return the newest fleet state."""
        return self.store.state

    @property
    def records(self) -> list[CommandRecord]:
        """Return every command that was given."""
        return list(self._records.values())

    @property
    def left(self) -> float:
        """Return the seconds until the time limit."""
        return max(0.0, self._deadline - time.monotonic())

    @property
    def under_way(self) -> list[CommandRecord]:
        """Return the open commands."""
        return [
            record for id_, record in self._records.items() if not record.is_decided or id_ in self._driven
        ]

    def give(self, request: Request) -> Iterator[Outcome]:
        """Check a request, send it, and wait for the outcome of each command. To one robot they are sent in
        sequence, up to the first failure; to several, all at once."""
        request, unable = divide(self.state, request)
        yield from unable
        wrong = self.objections(request)
        if wrong:
            yield from self._hold_back(request.commands, wrong)
        elif len({command.robot for command in request.commands}) > 1:
            yield from self.await_ends(self.link.submit_all(request.commands))
        else:
            yield from self._one_after_the_other(request.commands)

    def check(self, request: Request) -> list[Outcome]:
        """Return the objections to a request now, empty if it would be sent."""
        wrong = self.objections(request)
        return list(self._hold_back(request.commands, wrong)) if wrong else []

    def warnings(self, request: Request) -> list[Problem]:
        """Return the warnings that a person may override, empty if the request is never sent."""
        found = self.objections(request)
        return [] if any(problem.blocks for problem in found) else found

    def override(self) -> None:
        """Ignore warnings from now on."""
        self._how = replace(self._how, yes=True)
        self.begin()

    def objections(self, request: Request) -> list[Problem]:
        """Return all objections to a request now, errors first; empty if it would be sent."""
        found = [*problems(self.state, request, self._how.permissions), *losses(self.state, request)]
        if not self._how.until_done:
            found += unattended(self.state, request)
        asked = [command for command in request.commands if not isinstance(command, PauseRobot | ResumeRobot)]
        for name in dict.fromkeys(command.robot for command in asked):
            if absent := unreported(self.state.robots[name]):
                # The link holds an order for a vehicle's first state, beyond the time limit of this line.
                is_held = "state" in absent and any(
                    isinstance(one, PlaceOrder) and one.robot == name for one in asked
                )
                found.append(
                    Problem(
                        "missing",
                        Message("{name}: {absent} missing", name=name, absent=", ".join(absent)),
                        blocks=is_held,
                    )
                )
        return [problem for problem in found if problem.blocks or not self._how.yes]

    def _hold_back(self, commands: Sequence[Command], wrong: list[Problem]) -> Iterator[Outcome]:
        words = ", ".join(problem.text for problem in wrong)
        words += "" if wrong[0].blocks else ": use --yes to send anyway"
        code = CODES.get(wrong[0].check, NOT_DONE) if wrong[0].blocks else NOT_DONE
        yield from (unsent(self.state, command, words, code) for command in commands)

    def _one_after_the_other(self, commands: Sequence[Command]) -> Iterator[Outcome]:
        for number, command in enumerate(commands):
            command_id = self.link.submit(command)
            (outcome,) = self.await_ends([command_id])
            if outcome.code == DONE and self._how.until_done:
                self._driven[command_id] = outcome
                continue
            yield outcome
            if outcome.code != DONE:
                rest = commands[number + 1 :]
                yield from (unsent(self.state, one, "the previous command failed", NOT_DONE) for one in rest)
                break
        while self._driven:
            command_id, outcome = next(iter(self._driven.items()))
            latest = partial(self._records.__getitem__, command_id)
            driven = follow_order(latest, outcome, self.store, self.left)
            del self._driven[command_id]
            yield driven

    def pause(self, robots: Sequence[str]) -> Iterator[Outcome]:
        """Pause robots, those of a bridge as soon as it is connected, however slow the others are."""
        unable = [name for name in robots if unaccepted(self.state, PauseRobot(name))]
        yield from _unable(self.state, map(PauseRobot, unable))
        ids, waiting = list[int](), [name for name in robots if name not in unable]
        until = time.monotonic() + min(LINK_WITHIN, self.left)
        while waiting:
            now = self._reached(waiting, until - time.monotonic())
            ids += self.link.submit_all([PauseRobot(name) for name in now])
            waiting = [name for name in waiting if name not in now]
        yield from self.await_ends(ids)

    def _reached(self, waiting: list[str], seconds: float) -> list[str]:
        """Return the robots to which a pause can be sent; all of them after the time limit."""

        def connected(state: FleetState) -> list[str]:
            links = {name: state.links[state.robots[name].link] for name in waiting}
            return [name for name, link in links.items() if link.commands_connected]

        if self._how.permissions.read_only or not self.store.wait(connected, seconds):
            return waiting
        return connected(self.state)

    def await_ends(self, ids: Sequence[int]) -> Iterator[Outcome]:
        """Wait for the end of each command."""
        for command_id in ids:
            # However little time is left for an answer, whether it was sent is known here.
            self.store.wait(partial(self._was_tried, command_id), HANDOVER)
            self.store.wait(partial(self._has_ended, command_id), self.left)
            self._withdraw(command_id)
            record = self._records.get(command_id)
            if record is not None:
                yield self._with_link(ended(self.state, record, self._how.timeout), record)

    def _withdraw(self, command_id: int) -> None:
        """Never send an order that still waits at the time limit, unless it leaves just now."""
        record = self._records.get(command_id)
        if record is not None and record.stage is Stage.WAITING:
            words = Message(
                "waited {detail} until --timeout {timeout}",
                detail=record.detail,
                timeout=f"{self._how.timeout:g}",
            )
            self.link.post(CommandAdvanced(command_id, Stage.NOT_SENT, time.monotonic(), words))
            self.store.wait(lambda _: self._records[command_id].stage is not Stage.WAITING, HANDOVER)

    def _was_tried(self, command_id: int, _: FleetState) -> bool:
        return command_id in self._records and self._records[command_id].stage is not Stage.CHECKED

    def _has_ended(self, command_id: int, _: FleetState) -> bool:
        return command_id in self._records and self._records[command_id].is_decided

    def _with_link(self, outcome: Outcome, record: CommandRecord) -> Outcome:
        """Return the exit code of no link, if that is the reason it was not sent."""
        if record.stage is not Stage.NOT_SENT or self._how.permissions.read_only:
            return outcome
        link = self.state.links[self.state.robots[record.command.robot].link]
        if link.commands_connected and link.command_path is not CommandPath.DEAD:
            return outcome
        words = f"{outcome.words}: {link.command_reason}" if link.command_reason else outcome.words
        return replace(outcome, words=words, code=NO_LINK)
