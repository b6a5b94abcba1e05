"""Secrets come from safe places, reach only the bridge, and stand nowhere else."""

import asyncio
import gzip
import hashlib
import json
import zipfile
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from websockets.asyncio.server import ServerConnection, serve
from websockets.http11 import Request, Response

from fleet_tui.config.schema import Link
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import Keyframe
from tests.support.invariants import linked
from tests.support.polling import HANGS
from tests.support.proxied_link import lost
from tests.support.secrets import SHARED, WORD, bridged, kept
from tests.support.terminal_session import in_terminal

Attend = Callable[[ServerConnection], object]


@asynccontextmanager
async def guarded(attend: Attend, header: str = "") -> AsyncIterator[str]:
    """A server that wants a header."""

    def look(connection: ServerConnection, request: Request) -> Response | None:
        if header and request.headers.get("Authorization") != header:
            # Some servers say back what they got.
            return connection.respond(401, f"wrong: {request.headers.get('Authorization')}")
        return None

    async with serve(attend, "127.0.0.1", 0, process_request=look) as running:  # type: ignore[arg-type]  # any coroutine
        yield f"ws://127.0.0.1:{next(iter(running.sockets)).getsockname()[1]}"


async def _stay(connection: ServerConnection) -> None:
    await connection.wait_closed()


async def test_the_authorization_header_is_sent_and_renewed(tmp_path: Path) -> None:
    async with guarded(_stay, WORD) as url:
        link = Link(url, authorization_file=kept(tmp_path / "word", "Bearer old"))
        async with linked(bridged(link)) as (_, store):
            await store.until(lost("access denied (HTTP 401): authorization not accepted"))
            kept(tmp_path / "word", WORD)
            await store.until(lambda state: state.links["rosbridge"].phase.value == "up")
            (tmp_path / "word").chmod(0o644)
    assert WORD not in repr(store.events) and "Bearer" not in repr(store.events)


async def test_rosauth_shows_that_it_knows_the_secret_before_anything_else(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    firsts: asyncio.Queue[str | bytes] = asyncio.Queue()

    async def attend(connection: ServerConnection) -> None:
        firsts.put_nowait(await connection.recv())
        await connection.wait_closed()

    monkeypatch.setenv("ROSAUTH", SHARED)
    async with guarded(attend) as url, linked(bridged(Link(url, rosauth_env="ROSAUTH"))):
        for _ in range(2):
            frame = json.loads(await asyncio.wait_for(firsts.get(), HANGS))
            # As rosauth's ros_mac_authentication computes it.
            fields = (frame[name] for name in ("client", "dest", "rand", "t", "level", "end"))
            text = SHARED + "".join(map(str, fields))
            assert frame["op"] == "auth" and frame["end"] > frame["t"]
            assert frame["mac"] == hashlib.sha512(text.encode()).hexdigest()
            assert SHARED not in json.dumps(frame)


async def test_a_wrong_rosauth_secret_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    async def attend(connection: ServerConnection) -> None:
        await connection.recv()

    monkeypatch.setenv("ROSAUTH", SHARED)
    async with guarded(attend) as url:
        async with linked(bridged(Link(url, rosauth_env="ROSAUTH"))) as (_, store):
            await store.until(lost("check the rosauth secret and the clocks"))
        async with linked(bridged(Link(url))) as (_, store):
            await store.until(lost("rosauth required (rosauth_file)?"))


async def _says_back(connection: ServerConnection) -> None:
    status = {"op": "status", "level": "error", "msg": f"not you: {WORD}"}
    await connection.send(json.dumps(status))
    await connection.close(1008, f"not you: {WORD}")


async def test_what_a_server_says_back_is_hidden(tmp_path: Path) -> None:
    async with guarded(_says_back, WORD) as url:
        config = f'[rosbridge]\nurl = "{url}"\nauthorization_file = "word"\n'
        (tmp_path / "config.toml").write_text(config + '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n')
        kept(tmp_path / "word", WORD)

        def looked_at() -> bytes:
            arguments = ("--debug", "--config", str(tmp_path / "config.toml"))
            with in_terminal(tmp_path, *arguments) as running:
                running.shows("bad data")
                running.press("q")
                running.ends()
                return running.sent

        assert b"s3same" not in await asyncio.to_thread(looked_at)
    written = [path for path in (tmp_path / "state").rglob("*") if path.is_file()]
    contents = {
        path.suffix: b"".join(_unpacked(path)) if path.suffix == ".gz" else path.read_bytes()
        for path in written
    }
    assert not [suffix for suffix, content in contents.items() if b"s3same" in content]
    repeated = {suffix for suffix, content in contents.items() if b"not you: ******" in content}
    assert repeated == {".log", ".jsonl", ".gz", ".sqlite"}


@pytest.mark.parametrize("mode", [0o600, 0o644])
async def test_no_output_holds_a_secret(tmp_path: Path, mode: int) -> None:
    """The real console and the command line, at their most talkative, with a server that repeats it."""
    async with guarded(_stay, "another") as url:
        config = tmp_path / "config.toml"
        config.write_text(
            f'[rosbridge]\nurl = "{url}/?token=hush-hush"\nauthorization_file = "word"\n'
            'rosauth_env = "MINE"\n[[floors]]\nname = "f"\n[[robots]]\nname = "r"\n'
        )
        kept(tmp_path / "word", WORD, mode)
        record = ("record", str(tmp_path / "state" / "x"), "--timeout", "2")
        status, bundle = ("status", "--timeout", "2"), ("doctor", "--bundle")
        for arguments in ((), ("check",), ("config", "show"), ("pause", "r"), status, bundle, record):
            output = await asyncio.to_thread(_seen, tmp_path, arguments, mode == 0o600)
            for hidden in (WORD, "s3same", SHARED, "hush-hush"):
                assert hidden not in output
    written = [path for path in (tmp_path / "state").rglob("*") if path.is_file()]
    for path in written:
        assert path.stat().st_mode & 0o077 == 0
        content = path.read_bytes()
        if content[:2] == b"\x1f\x8b":
            content = b"".join(_unpacked(path))
        elif zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                content = b"".join(map(archive.read, archive.namelist()))
            assert b"Bearer" not in content and b"effective settings" in content
        for hidden in (WORD, "s3same", SHARED, "hush-hush"):
            assert hidden.encode() not in content
    recorded = {path.name for path in written if path.suffix == ".gz" or path.name == "x"}
    assert len(recorded) == (2 if mode == 0o600 else 0)
    assert [path.suffix for path in written].count(".zip") == 1


def _unpacked(path: Path) -> Iterator[bytes]:
    """The content of a recording, compressed and encoded parts included."""
    for record in open_recording(path).records():
        yield repr(record).encode() + (record.state if isinstance(record, Keyframe) else b"")
    with gzip.open(path) as file:
        yield file.read()


def _seen(home: Path, arguments: tuple[str, ...], is_taken: bool) -> str:
    """Everything the program sends to its terminal."""
    config = ("--debug", "--config", str(home / "config.toml"))
    with in_terminal(home, *arguments, *config, MINE=SHARED) as running:
        if not arguments and is_taken:
            running.shows("authorization not accepted")
            running.press("q")
        running.ends()
        if not arguments and not is_taken:
            assert running.child.returncode == 2
            running.shows("chmod 600 it")
        return running.sent.decode(errors="replace")
