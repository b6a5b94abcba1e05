"""The `order`, `cancel`, `clear`, `pause`, `resume` and `run` commands, without a screen."""

import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from functools import partial

import click

from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE, NOT_SENT, Outcome, exit_code, print_outcome
from fleet_tui.cli.orders.sending import LINK_WITHIN, How, Sending, reaches, unreported
from fleet_tui.cli.session import session
from fleet_tui.commands.checks import no_link
from fleet_tui.commands.language.grammar import ALL, parse_words
from fleet_tui.commands.language.set_up import USAGE as SET_UP
from fleet_tui.commands.language.set_up import floor_of
from fleet_tui.commands.language.words import find_robot
from fleet_tui.commands.rights import right_of
from fleet_tui.commands.rivals import rivals_text
from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.rights import permissions_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.records.audit.log import auditing, operator_name
from fleet_tui.records.desk.watching import watched_desk
from fleet_tui.situation.batches import summary
from fleet_tui.situation.reported_motion import SELDOM, STANDS_AFTER, is_moving
from fleet_tui.situation.robots import may_be_back
from fleet_tui.text.errors import CommandError
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.commands import command_text
from fleet_tui.ui.view.lines.questions import question

STANDING_WITHIN = STANDS_AFTER + SELDOM + 1.0
"""Seconds until a robot at rest has been seen for long enough to count as standing."""
MAP_WITHIN = 3.0


def await_set_up(given: Sending, config: Config, name: str, words: Sequence[str]) -> None:
    """Wait for the reports that a set-up command needs besides those of an order."""
    if words[0] in ("set-pose", "localise"):

        def stands(state: FleetState) -> bool:
            return not is_moving(state.robots[name], state.now)

        given.store.wait(stands, min(STANDING_WITHIN, given.left))
    if words[0] in ("set-pose", "goto") and len(words) > 3:
        _await_map(given, config, name)


def _await_map(given: Sending, config: Config, name: str) -> None:
    """Load the map of a robot's floor, or subscribe to its live one."""
    robot = given.state.robots[name]
    try:
        floor = floor_of(robot)
    except CommandError:
        return
    entry = next(one for one in config.floors if one.name == floor)
    if entry.map:
        # With numpy, whose import takes longer than a whole command.
        from fleet_tui.maps.images import load_floor_map

        given.link.post(load_floor_map(floor, config.beside(entry.map), config.profile.origin == "added"))
    elif "map" in robot.kind.reports:
        given.link.show_map(name, floor)
    else:
        return

    def has_map(state: FleetState) -> bool:
        known = map_of(state, state.robots[name], floor) is not None
        return known or bool(state.floors[floor].problem)

    given.store.wait(has_map, min(MAP_WITHIN, given.left))


LABELS_WITHIN = 1.0
"""Additional seconds for labels, which a floor need not have, for the robot's report on whether it is paused,
and for goals, which may be absent."""

LOOK = "check with fleet-tui status and fleet-tui audit"

ENDING = (signal.SIGTERM, signal.SIGHUP)
"""Signals of `timeout`, of services and of a closed terminal."""

Say = Callable[..., None]

_SETTINGS = {"read-only": "operator.read_only", "not armed": "operator.armed"}
"""What keeps a console from commanding, and its place in the configuration."""


class _Ended(KeyboardInterrupt):
    """Ended by a signal: like Ctrl-C, but for the exit code."""


def _end(number: int, _frame: object) -> None:
    raise _Ended(number)


def how(config: Config, timeout: float, yes: bool, until_done: bool = False) -> How:
    """Return the settings for commands from the config and the options."""
    return How(permissions_of(config), timeout, yes, until_done)


def forbidden(config: Config, needed: Right = Right.DISPATCH, arms: bool = True) -> str:
    """Return the reason that this console may not do what needs a right, empty if it may. `arms`: it needs an
    armed console, as all but pauses do."""
    objection = permissions_of(config).objection(needed, arms)
    if objection is None:
        return ""
    setting = _SETTINGS.get(objection.check)
    return f"this console is {objection.check}: {setting} in {config.path}" if setting else objection.text


def robots_of(config: Config, word: str) -> list[str]:
    """Return the robots that a word means. Raises click's UsageError, naming the nearest, if there are
    none."""
    state = initial_state(config, 0.0)
    try:
        return list(state.robots) if word.casefold() == ALL else [find_robot(word, state).name]
    except CommandError as problem:
        raise click.UsageError(sanitize(str(problem))) from None


@contextmanager
def sending(config: Config, asked: How, say: Say) -> Iterator[Sending]:
    """Provide a link to send on, with the audit log kept; a signal ends it, open results are reported."""
    given = None
    # Under nohup it continues after its terminal is closed.
    numbers = [one for one in ENDING if signal.getsignal(one) is not signal.SIG_IGN]
    for number in numbers:
        signal.signal(number, _end)
    with ExitStack() as opened:  # and closed after the last records: that takes time
        try:
            link, store = opened.enter_context(session(config))
            name, warn = operator_name(config), partial(say, err=True)
            opened.enter_context(watched_desk(config, store, name, link.post, warn))
            given = Sending(link, store, asked)
            with auditing(state_folder(), config, store) as audit:
                given.log = audit.log_console
                try:
                    yield given
                finally:
                    for robot in dict.fromkeys(record.command.robot for record in given.records):
                        if others := rivals_text(given.state, robot):
                            say(sanitize(f"{robot}: also commanded by {others}"), err=True)
                    for note in audit.notes:
                        say(note, err=True)
        except KeyboardInterrupt as end:
            for number in (signal.SIGINT, *numbers):
                signal.signal(number, signal.SIG_IGN)  # a second one would only garble the output now
            with suppress(OSError):  # stderr may be gone
                if given and given.under_way:
                    _say_what_is_open(given, say)
                else:
                    say("interrupted: nothing else sent", err=True)
            if isinstance(end, _Ended):
                raise SystemExit(128 + end.args[0]) from None
            raise


def _say_what_is_open(given: Sending, say: Say) -> None:
    for record in given.under_way:
        known = f"order {record.order_id} stays in the queue"
        if record.has_further_leg(given.state.robots[record.command.robot].kind):
            known += ", but its remaining stops are not sent"
        if record.stage is Stage.WAITING:
            known = "it was waiting here and will not be sent"
        elif not record.is_decided:
            known = f"{record.stage.value}, may still be carried out"
        say(f"{command_text(given.state, record.command)}: outcome unknown: {known}; {LOOK}", err=True)


def await_reports(given: Sending, robots: Sequence[str], reports: bool, asks: bool = True) -> None:
    """Wait for a link to each of these robots and, if needed, for their reports; `asks`: where they come
    seldom, they are asked for."""

    def comes(holds: Callable[[FleetState, Robot], object], seconds: float) -> None:
        given.store.wait(
            lambda state: all(holds(state, state.robots[name]) for name in robots), min(seconds, given.left)
        )

    if not reports:
        comes(reaches, LINK_WITHIN)
        return
    comes(
        lambda state, robot: reaches(state, robot) and (_is_received(robot) or bool(robot.kind.optional)),
        LINK_WITHIN,
    )
    if asks:
        given.link.request_states(name for name in robots if unreported(given.state.robots[name]))
    comes(_has_state, given.left)
    if all(reaches(given.state, given.state.robots[name]) for name in robots):
        comes(
            lambda _, robot: _has_labels(robot) and _reports_pause(robot) and _reports_goals(robot),
            LABELS_WITHIN,
        )


def unreachable(state: FleetState, robots: Iterable[str]) -> str:
    """Return the reason that the first unreachable one of these robots is, empty if there are none."""
    asked = (no_link(state, state.robots[name], ResumeRobot(name)) for name in robots)
    return next((problem.text for found in asked for problem in found), "")


def _is_received(robot: Robot) -> bool:
    """Tell whether it is online, and all reports needed for checks have arrived."""
    return robot.last_received is not None and not unreported(robot)


def _has_state(state: FleetState, robot: Robot) -> bool:
    """Tell whether the state of a vehicle is there, which comes every 30 s, or will not come."""
    is_away = not reaches(state, robot) or (robot.is_gone and not may_be_back(state, robot))
    return not robot.kind.optional or not unreported(robot) or is_away


def _has_labels(robot: Robot) -> bool:
    """Tell whether the labels of every floor have arrived."""
    return not robot.kind.expects("labels") or all(robot_map.labels for robot_map in robot.maps.values())


def _reports_pause(robot: Robot) -> bool:
    return robot.paused is not None or not robot.says_paused


def _reports_goals(robot: Robot) -> bool:
    """Tell whether the robot's goals are known: its action servers are silent before their first goal."""
    return not robot.kind.keeps_goals or bool(robot.goals)


def command(config: Config, words: Sequence[str], asked: How, as_json: bool, say: Say) -> int:
    """Run one command, in the command language; return the exit code."""
    robots = robots_of(config, words[1])

    def unsent(reason: str, code: int) -> int:
        typed = sanitize(" ".join(words))
        return said([Outcome(robots[0], typed, typed, NOT_SENT, reason, code)], as_json, say)

    if reason := forbidden(config, right_of(words[0])):
        return unsent(reason, NOT_DONE)
    with sending(config, asked, say) as given:
        await_reports(given, robots, words[0] != "resume")
        if reason := unreachable(given.state, robots):
            return unsent(reason, NO_LINK)
        if words[0] in SET_UP:
            await_set_up(given, config, robots[0], words)
        state = given.state
        try:
            request = parse_words(words, state)
        except CommandError as wrong:
            absent = unreported(state.robots[robots[0]])
            if absent:
                return unsent(f"{wrong}; {', '.join(absent)} missing", NOT_DONE)
            raise click.UsageError(sanitize(str(wrong))) from None
        if not as_json and sys.stdin.isatty():
            _ask(given, request)
        return said(given.give(request), as_json, say, given)


def _ask(given: Sending, request: Request) -> None:
    """Ask a person at a terminal for the confirmation that --yes gives."""
    found = given.warnings(request)
    shown = [problem for problem in found if problem.check != "losses"]
    if found and click.confirm(question(given.state, request, shown), err=True):
        given.override()


def pause(config: Config, word: str, asked: How, as_json: bool, say: Say) -> int:
    """Pause a robot, or all, on each bridge as soon as there is a connection; return the exit code."""
    robots = robots_of(config, word)
    if reason := asked.permissions.refusal(Right.DISPATCH):
        refused = (Outcome(name, "pause", f"{name} pause", NOT_SENT, reason, NOT_DONE) for name in robots)
        return said(refused, as_json, say)
    with sending(config, asked, say) as given:
        return said(given.pause(robots), as_json, say, given)


def said(outcomes: Iterable[Outcome], as_json: bool, say: Say, given: Sending | None = None) -> int:
    """Print each outcome as it arrives, and the total of robots; return the exit code of all."""
    codes, before = list[int](), len(given.records) if given else 0
    for outcome in outcomes:
        print_outcome(outcome, as_json, say)
        codes.append(outcome.code)
    # Slower bridges got it later: all of it is one request.
    batch = given.records[before:] if given and not as_json else []
    if given and len(batch) > 1 and all(isinstance(one.command, PauseRobot | ResumeRobot) for one in batch):
        what, words = summary(given.state, batch)
        say(sanitize(f"{what}: {words}"), err=exit_code(codes) != DONE)
    return exit_code(codes)
