"""`fleet-tui routine install`: a timer of the user's systemd."""

import shlex

import click

from fleet_tui.cli.orders.outcome import DONE, NOT_DONE
from fleet_tui.config.schema import Config
from fleet_tui.features.routines.cli.reading import Say, named_routine
from fleet_tui.features.routines.lines import problem_line
from fleet_tui.features.routines.units import install, unit_files
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.sanitize import sanitize


def install_routine(config: Config, name: str, only_print: bool, say: Say) -> int:
    """Write or print the units of a routine; return the exit code."""
    file = named_routine(config, name)
    for problem in file.parsed.problems:
        say(problem_line(file.name, problem), err=True)
    if file.parsed.problems:
        return NOT_DONE
    try:
        units = unit_files(file, config.path)
        if only_print:
            for unit, text in units.items():
                say(sanitize(f"# {unit}"))
                say("\n".join(map(sanitize, text.splitlines())))
            return DONE
        for path in install(units):
            say(sanitize(f"written: {path}"))
    except RoutineError as problem:
        raise click.UsageError(sanitize(str(problem))) from None
    timer = shlex.quote(f"fleet-tui-routine-{file.name}.timer")
    say(f"start it: systemctl --user daemon-reload; systemctl --user enable --now {timer}")
    say("also while nobody is logged in: loginctl enable-linger")
    return DONE
