"""The `run` command: a file of commands, one after the other."""

from collections.abc import Iterable, Iterator

import click

from fleet_tui.cli.orders.giving import Say, await_reports, forbidden, said, sending, unreachable
from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE, Outcome, exit_code, unsent
from fleet_tui.cli.orders.sending import How, Sending, divide
from fleet_tui.commands.language.grammar import parse
from fleet_tui.commands.language.words import find_robot, tokens
from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.text.errors import CommandError
from fleet_tui.text.sanitize import sanitize

Line = tuple[int, str]
WOULD = "would be sent"
FREE = ("pause", "resume")
"""Commands that are not checked against a robot's reports."""


def lines_of(text: str) -> list[Line]:
    """Return the commands of a file, each with its line's number; `#` begins a comment line."""
    lines = enumerate((line.strip() for line in text.splitlines()), 1)
    return [(number, line) for number, line in lines if line and not line.startswith("#")]


def _robots(line: str, state: FleetState) -> Iterator[str]:
    """Return the robots that a line may name: at its start, or after the command."""
    for token in tokens(line)[:2]:
        try:
            yield find_robot(token.text, state).name
        except CommandError:
            continue


def _requests(lines: Iterable[Line], state: FleetState) -> list[tuple[int, Request]]:
    """Return the request of each line. Raises click's UsageError with every invalid line."""
    found, wrong = list[tuple[int, Request]](), list[str]()
    for number, line in lines:
        try:
            found.append((number, parse(line, state)))
        except CommandError as problem:
            wrong.append(sanitize(f"line {number}: {problem}"))
    if wrong:
        raise click.UsageError("nothing sent\n" + "\n".join(wrong))
    return found


def run_batch(
    config: Config, lines: list[Line], how: How, dry_run: bool, keep_going: bool, as_json: bool, say: Say
) -> int:
    """Send the commands of a file, each when the one before has ended; return the exit code. All lines are
    parsed before the first is sent. With `dry_run` nothing is sent."""
    only_pauses = all(line.split()[0].casefold() == "pause" for _, line in lines)
    if (reason := forbidden(config, arms=not only_pauses)) and not dry_run:
        say(f"fleet-tui: nothing sent: {reason}", err=True)
        return NOT_DONE
    with sending(config, how, say) as given:
        busy = [line for _, line in lines if line.split()[0].casefold() not in FREE]
        named = [name for line in busy for name in _robots(line, given.state)]
        await_reports(given, list(dict.fromkeys(named)) or list(given.state.robots), bool(named), not dry_run)
        if reason := unreachable(given.state, named):
            say(f"fleet-tui: nothing sent: {sanitize(reason)}", err=True)
            return NO_LINK
        requests = _requests(lines, given.state)
        if dry_run:
            return said((one for _, request in requests for one in _tried(given, request)), as_json, say)
        return _give_all(given, requests, keep_going, as_json, say)


def _give_all(
    given: Sending, requests: list[tuple[int, Request]], keep_going: bool, as_json: bool, say: Say
) -> int:
    codes = list[int]()
    for done, (number, request) in enumerate(requests, 1):
        given.begin()
        codes.append(said(given.give(request), as_json, say, given))
        if codes[-1] != DONE and not keep_going:
            left = len(requests) - done
            say(f"stopped at line {number}, {left} line{'s' * (left != 1)} not sent", err=True)
            break
    return exit_code(codes)


def _tried(given: Sending, request: Request) -> list[Outcome]:
    """Return the expected result of a line, in the current state of the fleet."""
    request, unable = divide(given.state, request)
    held = given.check(request)
    return [*unable, *(held or [unsent(given.state, one, "", DONE, WOULD) for one in request.commands])]
