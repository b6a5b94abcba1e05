"""`fleet-tui routine check`: all problems, else the timeline."""

import json

import msgspec

from fleet_tui.cli.orders.giving import unreachable
from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE
from fleet_tui.cli.orders.sending import How, Sending
from fleet_tui.cli.session import session
from fleet_tui.config.schema import Config
from fleet_tui.features.routines.blocks import RoutineProblem
from fleet_tui.features.routines.cli.reading import Say, await_robots, named_routine
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.lines import problem_line, timeline_lines
from fleet_tui.features.routines.rules.timeline import TimelineEntry
from fleet_tui.features.routines.start import problems_of, timeline_of
from fleet_tui.model.problem import Permissions
from fleet_tui.text.language import in_english
from fleet_tui.text.sanitize import sanitize

VERSION = 1


def check(config: Config, name: str, within: float, as_json: bool, say: Say) -> int:
    """Check a routine, within seconds for the link; return the exit code."""
    file = named_routine(config, name)
    no_link, entries = "", list[TimelineEntry]()
    problems = list(file.parsed.problems)
    if not problems:
        with session(config) as (link, store):
            given = Sending(link, store, How(Permissions(), within))
            robots = await_robots(given, file, asks=False)
            problems, no_link = problems_of(given.state, file), unreachable(given.state, robots)
            if not problems:
                entries = timeline_of(given.state, file)
    _print(file, problems, entries, no_link, as_json, say)
    if problems:
        return NO_LINK if no_link else NOT_DONE
    return DONE


def _print(
    file: RoutineFile,
    problems: list[RoutineProblem],
    entries: list[TimelineEntry],
    no_link: str,
    as_json: bool,
    say: Say,
) -> None:
    if as_json:
        found = {"problems": problems, "no_link": no_link, "timeline": entries}
        say(
            json.dumps(
                {"version": VERSION, "routine": file.name, **msgspec.to_builtins(found, enc_hook=in_english)}
            )
        )
        return
    for problem in problems:
        say(problem_line(file.name, problem), err=True)
    if no_link:
        say(sanitize(f"{file.name}: not checked against the robots: {no_link}"), err=True)
    if not problems:
        say(f"{file.name}: no problems; if it started now:")
        for line in timeline_lines(entries):
            say(line)
