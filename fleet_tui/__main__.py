"""`python -m fleet_tui` and the `fleet-tui` command: every end of the command line has its exit code."""

import os
import sys
from typing import NoReturn

import click

from fleet_tui.cli import commands
from fleet_tui.errors import ConfigError, FleetError
from fleet_tui.terminal.ending import PATIENCE, end_within


def _end(code: int, *lines: str) -> NoReturn:
    for line in lines:
        click.echo(line, err=True)
    sys.exit(code)


def _run() -> None:
    """Run the command line."""
    # Tracebacks are for --debug, wherever it stands.
    debug = "--debug" in sys.argv
    try:
        commands.main(standalone_mode=False)
    except click.exceptions.Abort:
        _end(130)
    except click.ClickException as problem:
        _end(2, f"fleet-tui: {problem.format_message()}", "fleet-tui --help lists what there is.")
    except ConfigError as problem:
        _end(2, *problem.problems)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _end(1)
    except KeyboardInterrupt:
        _end(130)
    except FleetError as problem:
        _end(1, f"fleet-tui: {problem}")
    except Exception as problem:
        if debug:
            raise
        import logging

        from fleet_tui.log_file import log_to_file

        path = log_to_file(debug)
        logging.getLogger(__name__).exception("fatal")
        _end(1, f"fleet-tui: internal error: {problem} (details in {path}, or with --debug)")


def main() -> None:
    """Run the command line; every end has its exit code. What hangs in a thread then is not waited for."""
    code: object = 1
    try:
        _run()
        code = 0
    except SystemExit as end:
        code = end.code
        raise
    finally:
        end_within(PATIENCE, code if isinstance(code, int) else int(code is not None))


if __name__ == "__main__":
    main()
