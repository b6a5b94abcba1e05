"""`python -m fleet_tui` and the `fleet-tui` command: every way to end has its exit code."""

import codecs
import errno
import gc
import io
import logging
import os
import signal
import sys
import textwrap
import traceback
from typing import IO, TYPE_CHECKING, Any, NoReturn

from fleet_tui.config.log_file import log_to_file
from fleet_tui.text.ascii_fallback import ascii_fallback
from fleet_tui.text.errors import ConfigError, FleetError, LinkError, MapError
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.terminal.ending import PATIENCE, end_within

if TYPE_CHECKING:
    from pathlib import Path

FULL = (errno.ENOSPC, errno.EDQUOT)
MOST = 100
"""Maximum number of configuration problems listed at once."""


def _more(count: int) -> list[str]:
    return [f"and {count} more"] if count > 0 else []


def _end(code: int, *lines: str) -> NoReturn:
    for line in lines:
        sys.stderr.write(f"{_folded(sanitize(line))}\n")
    sys.exit(code)


def _folded(line: str) -> str:
    """Return a line folded between words at the terminal's width; elsewhere, for scripts, it stays whole."""
    columns = os.get_terminal_size(sys.stderr.fileno()).columns if sys.stderr.isatty() else 0
    if len(line) <= columns or columns == 0:
        return line
    return textwrap.fill(
        line, columns, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
    )


def _end_saying(problem: FleetError) -> NoReturn:
    if isinstance(problem, ConfigError):
        _end(2, *problem.problems[:MOST], *_more(len(problem.problems) - MOST))
    code = 3 if isinstance(problem, LinkError) else 2 if isinstance(problem, MapError) else 1
    _end(code, f"fleet-tui: {problem}")


def _run_command() -> None:
    import click  # here, so that Ctrl-C while they are imported ends like Ctrl-C

    from fleet_tui.main import commands

    try:
        commands.main(prog_name="fleet-tui", standalone_mode=False)
    except click.exceptions.Abort:
        _end(130)
    except click.ClickException as problem:
        message = f"fleet-tui: {problem.format_message()}".splitlines()
        context = problem.ctx if isinstance(problem, click.UsageError) else None
        if context and isinstance(problem, click.MissingParameter):
            message += context.get_usage().splitlines()
        _end(2, *message, *([f"Run {context.command_path} --help for usage."] if context else []))


def _open_closed_streams() -> None:
    """Open closed standard streams, as in cron jobs and services: the next opened file would take their
    number."""
    sys.stdin = sys.stdin or _nothing("r")
    sys.stdout = sys.stdout or _nothing("w")
    sys.stderr = sys.stderr or _nothing("w")


def _nothing(mode: str) -> IO[Any]:
    return os.fdopen(os.open(os.devnull, os.O_RDWR), mode)


def _never_fail_to_encode() -> None:
    """Replace unencodable characters: Latin-1 has none of our glyphs, and not every letter of a site's
    names."""
    codecs.register_error("ascii_fallback", ascii_fallback)
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="ascii_fallback")


def _message(problem: Exception, log: "Path | None") -> str:
    if isinstance(problem, OSError) and problem.errno in FULL and problem.filename is None:
        return f"cannot write the output: {problem.strerror}"
    where = "with --debug" if log is None else f"in {log}, or with --debug"
    message = truncate(str(problem)) or type(problem.__cause__ or problem).__name__
    return f"internal error: {message} (details {where})"


def run() -> None:
    """Run the command line; SystemExit has the exit code of every way to end, but for 0."""
    _open_closed_streams()
    _never_fail_to_encode()
    # Tracebacks need --debug, in any position.
    debug = "--debug" in sys.argv
    try:
        _run_command()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _end(1)
    except KeyboardInterrupt:
        _end(130)
    except FleetError as problem:
        _end_saying(problem)
    except Exception as problem:
        if debug:
            # Like Python's message, without control characters that could affect a terminal.
            _end(1, *traceback.format_exc().splitlines())
        path = log_to_file(debug)
        logging.getLogger(__name__).exception("fatal")
        _end(1, f"fleet-tui: {_message(problem, path)}")


def main() -> None:
    """Run the command line to the end of the process. Hanging threads are not waited for."""
    code: object = 1
    try:
        run()
        code = 0
    except SystemExit as end:
        code = end.code
        raise
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C would only garble the end of the first
        end_within(PATIENCE, code if isinstance(code, int) else int(code is not None))
        gc.freeze()  # Python would search all objects for garbage before it ends: half a second of a console


if __name__ == "__main__":
    main()
