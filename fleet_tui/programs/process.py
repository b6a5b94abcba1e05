"""Processes of others, run within limits: of time, and of what they print."""

import asyncio
import os
import signal
from asyncio.subprocess import DEVNULL, PIPE, STDOUT, Process
from collections.abc import AsyncIterator, Mapping, Sequence
from contextlib import asynccontextmanager, suppress
from pathlib import Path

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message

LARGEST = 256 * 1024
"""Bytes of output after which a process that should be brief is ended."""
DRAIN = 0.2
"""Seconds for the last output of a process that has ended: what it started may hold the pipe for ever."""
POLL = 0.02


class EndedProcess(Struct, frozen=True):
    """The end of a process: its exit code, None if it never came to that; then `problem` says why."""

    code: int | None
    output: str = ""
    problem: Message = EMPTY
    is_late: bool = False


@asynccontextmanager
async def running(
    arguments: Sequence[str],
    environment: Mapping[str, str] | None = None,
    folder: Path | None = None,
    stdin: int = DEVNULL,
) -> AsyncIterator[Process]:
    """Start a process apart from our terminal, and end it with all that it started; by default with our
    environment, in our folder. Raises OSError, ValueError if it can't be started."""
    process = await asyncio.create_subprocess_exec(
        *arguments,
        stdin=stdin,
        stdout=PIPE,
        stderr=STDOUT,
        start_new_session=True,
        env=environment,
        cwd=folder,
    )
    try:
        yield process
    finally:
        _kill(process)
        try:
            with suppress(TimeoutError):  # its end is told to this loop, which may close next
                async with asyncio.timeout(DRAIN):
                    await exit_code(process)
        finally:
            # Else the pipe stays open for as long as a grandchild holds it.
            process._transport.close()  # type: ignore[attr-defined]  # typeshed leaves it out


def _kill(process: Process) -> None:
    if process.returncode is None:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)


async def run(
    arguments: Sequence[str],
    within: float,
    environment: Mapping[str, str] | None = None,
    folder: Path | None = None,
    given: str = "",
) -> EndedProcess:
    """Run a process to its end, for at most `within` seconds, with what it is `given` to read."""
    output, stdin = bytearray(), PIPE if given else DEVNULL
    try:
        async with asyncio.timeout(within), running(arguments, environment, folder, stdin) as process:
            reading = asyncio.ensure_future(_read(process, output))
            try:
                await _give(process, given)
                code = await exit_code(process)
                await asyncio.wait({reading}, timeout=DRAIN)
            finally:
                reading.cancel()
    except TimeoutError:
        return EndedProcess(
            None, _text(output), Message("no answer within {within} s", within=f"{within:.0f}"), is_late=True
        )
    except (OSError, ValueError) as problem:
        return EndedProcess(None, "", not_started(arguments[0], problem))
    if len(output) >= LARGEST:
        return EndedProcess(
            None,
            "",
            Message(
                "{arguments}: stopped after {limit} kB of output",
                arguments=arguments[0],
                limit=LARGEST // 1024,
            ),
        )
    return EndedProcess(code, _text(output))


async def exit_code(process: Process) -> int:
    """Return the exit code once the process itself has ended: `Process.wait` waits for its pipe, too."""
    waiting = asyncio.ensure_future(process.wait())
    try:
        while process.returncode is None:
            await asyncio.wait({waiting}, timeout=POLL)
        return process.returncode
    finally:
        waiting.cancel()


def not_started(program: str, problem: Exception) -> Message:
    """Return the reason that a process could not be started, with its remedy."""
    if isinstance(problem, FileNotFoundError):
        return Message(
            "{program}: not found: install it, or write its full path in the configuration", program=program
        )
    if isinstance(problem, PermissionError):
        return Message("{program}: not executable by this user: check its mode and owner", program=program)
    return Message(
        "{program}: {problem}", program=program, problem=getattr(problem, "strerror", None) or problem
    )


async def _give(process: Process, given: str) -> None:
    if process.stdin is not None:
        with suppress(BrokenPipeError, ConnectionResetError):  # it need not read it
            process.stdin.write(given.encode())
            await process.stdin.drain()
        process.stdin.close()


async def _read(process: Process, output: bytearray) -> None:
    assert process.stdout is not None
    while block := await process.stdout.read(2**16):
        output += block[: LARGEST - len(output)]
        if len(output) >= LARGEST:
            _kill(process)
            return


def _text(output: bytearray) -> str:
    return output.decode("utf-8", "replace")
