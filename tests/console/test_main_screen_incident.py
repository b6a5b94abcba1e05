"""`b`: one key packs what a ticket needs."""

import threading
from collections.abc import Callable
from pathlib import Path

from tests.support.planted_console import planted


async def test_a_key_packs_and_says_where(tmp_path: Path) -> None:
    async with planted() as it:
        go_on = threading.Event()
        shots: list[str] = []

        def pack(shot: str, is_over: Callable[[], bool]) -> Path:
            shots.append(shot)
            go_on.wait(10)
            path = tmp_path / "incident.zip"
            path.write_bytes(b"0" * 1_200_000)
            return path

        it.app.main.files.pack = pack
        await it.press("b")
        await it.shows("packing an incident")
        await it.press("b")
        await it.shows("still packing")
        go_on.set()
        await it.shows("packed 1.2 MB: /")
    assert len(shots) == 1
    assert "robot_0" in shots[0] and shots[0].startswith("<svg")


async def test_what_fails_is_said() -> None:
    async with planted() as it:
        problems = [OSError("No space left on device"), ValueError("of ours")]

        def pack(shot: str, is_over: Callable[[], bool]) -> Path:
            raise problems.pop(0)

        it.app.main.files.pack = pack
        await it.press("b")
        await it.shows("incident not packed: No space left on device")
        await it.press("b")
        await it.shows("incident not packed: of ours")
        it.app.main.files.pack = None
        await it.press("b")
        await it.shows("nothing to pack")
