"""Processes within limits: late, loud, missing and left behind ones."""

import asyncio
from contextlib import suppress
from pathlib import Path

import pytest

from fleet_tui.programs.process import LARGEST, run, running
from tests.support.polling import until
from tests.support.terminal_session import exists


async def test_output_and_exit_code_are_told() -> None:
    ended = await run(["sh", "-c", "echo out; echo err >&2; exit 3"], 10.0)
    assert (ended.code, ended.output, ended.problem) == (3, "out\nerr\n", "")


async def test_a_process_that_hangs_is_ended_with_its_children(tmp_path: Path) -> None:
    noted = tmp_path / "pid"
    ended = await run(["sh", "-c", f"sleep 60 & echo $! > {noted}; wait"], 0.5)
    assert ended.is_late and ended.problem == "no answer within 0 s"
    await until(lambda: not exists(int(noted.read_text())))


async def test_one_that_floods_is_ended_and_its_output_not_kept() -> None:
    ended = await run(["yes"], 20.0)
    assert ended.code is None and ended.output == "" and f"{LARGEST // 1024} kB" in ended.problem


async def test_a_child_that_holds_the_pipe_is_not_waited_for() -> None:
    ended = await run(["sh", "-c", "sleep 60 & echo $!"], 20.0)
    assert ended.code == 0 and exists(int(ended.output))
    await run(["kill", ended.output.strip()], 5.0)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["no-such-program"], "no-such-program: not found: install it"),
        (["/etc/passwd"], "/etc/passwd: not executable by this user"),
        (["echo", "a\0b"], "embedded null byte"),
    ],
)
async def test_what_can_not_be_started_is_told_with_its_remedy(arguments: list[str], reason: str) -> None:
    ended = await run(arguments, 5.0)
    assert ended.code is None and reason in ended.problem


async def test_bytes_that_are_no_text_are_replaced() -> None:
    assert (await run(["printf", "\\377a"], 5.0)).output == "\ufffda"


async def test_a_process_that_is_left_is_ended() -> None:
    async with running(["sleep", "60"]) as process:
        assert exists(process.pid)
    await until(lambda: not exists(process.pid))


async def test_who_is_cancelled_twice_leaves_no_pipe_open() -> None:
    """As by the end of a program: a task that waits for the end of its process is cancelled, too."""
    started = asyncio.Event()
    processes = list[asyncio.subprocess.Process]()

    async def runs() -> None:
        async with running(["sleep", "60"]) as process:
            processes.append(process)
            started.set()
            await asyncio.Event().wait()

    task = asyncio.create_task(runs())
    await started.wait()
    task.cancel()
    await asyncio.sleep(0)  # it waits for the end of the process now
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
    transport = processes[0]._transport  # type: ignore[attr-defined]  # typeshed leaves it out
    assert transport.is_closing()
