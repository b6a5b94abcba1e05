"""Secrets come from safe places, reach only the bridge, and stand nowhere else."""

import asyncio
import gzip
import hashlib
import json
import os
import zipfile
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest
from msgspec.structs import replace
from websockets.asyncio.server import ServerConnection, serve
from websockets.http11 import Request, Response

from fleet_tui.config.access import access_problems, secret, unsafe_places
from fleet_tui.config.check import checked
from fleet_tui.config.load import load
from fleet_tui.config.schema import Config, Link
from fleet_tui.errors import ConfigError
from fleet_tui.recording.indexing import open_recording
from fleet_tui.recording.records import Keyframe
from tests.support.invariants import linked
from tests.support.proxied_link import lost
from tests.support.terminal_session import in_terminal
from tests.support.watched_store import config_of

WORD = "Bearer s3same-0pen"
SHARED = "0123456789abcdef"


def kept(path: Path, text: str, mode: int = 0o600) -> str:
    """A file with a secret in it."""
    path.write_text(text)
    path.chmod(mode)
    return str(path)


def bridged(link: Link) -> Config:
    return replace(config_of(link.url, 1), rosbridge=link)


@pytest.mark.parametrize(
    ("text", "mode", "words"),
    [
        (WORD, 0o640, "rosbridge.authorization_file: readable by others (mode 640): chmod 600 it"),
        (WORD, 0o604, "rosbridge.authorization_file: readable by others (mode 604): chmod 600 it"),
        ("", 0o600, "rosbridge.authorization_file: is empty"),
        (f"{WORD}\nX: y", 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
        (f"{WORD}\xe9", 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
        ("x" * 20_000, 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
    ],
)
def test_a_file_that_is_not_taken(tmp_path: Path, text: str, mode: int, words: str) -> None:
    link = Link(authorization_file=kept(tmp_path / "a", text, mode))
    assert access_problems(bridged(link)) == [words]


def test_a_file_that_is_taken(tmp_path: Path) -> None:
    link = Link(authorization_file=kept(tmp_path / "a", WORD + "\n"))
    assert access_problems(bridged(link)) == []
    assert secret(link, "authorization") == WORD
    os.mkfifo(tmp_path / "pipe", 0o600)
    for name, words in (("gone", "No such file"), ("pipe", "not a file"), ("a\0b", "no path")):
        (line,) = access_problems(bridged(Link(rosauth_file=str(tmp_path / name))))
        assert line.startswith("rosbridge.rosauth_file: ") and words in line


def test_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FLEET_WORD", WORD)
    assert secret(Link(authorization_env="FLEET_WORD"), "authorization") == WORD
    # Somebody may put the secret itself where the variable's name belongs.
    with pytest.raises(ConfigError) as caught:
        secret(Link(authorization_env=SHARED), "authorization")
    assert SHARED not in str(caught.value) and "authorization_env" in str(caught.value)


@pytest.mark.parametrize(
    ("link", "words"),
    [
        (Link("ws://ana:hush@a:1"), "url: user and password not allowed"),
        (Link("http://ana:hush@a:1/?token=hush"), "url: 'http://***@a:1/?***' is not an address"),
        (Link("ana:hu/sh@a:1"), "url: '***@a:1' is not an address"),
        (Link("ws://a", ca_file="x"), "ca_file: ws:// has no TLS"),
        (Link("wss://a", client_key="x"), "client_key: needs client_cert"),
        (Link("ws://a", rosauth_env="A", rosauth_file="b"), "rosauth_file: use rosauth_file or rosauth_env"),
    ],
)
def test_what_does_not_go_together(link: Link, words: str) -> None:
    for where, config in (
        ("rosbridge", bridged(link)),
        ("links.b", replace(config_of("ws://a"), links={"b": link})),
    ):
        (line,) = checked(config)
        assert line.startswith(f"{where}.{words}") and "hush" not in line


def test_files_of_a_link_lie_beside_the_config(tmp_path: Path) -> None:
    kept(tmp_path / "word", WORD)
    (tmp_path / "config.toml").write_text(
        '[links.b]\nurl = "wss://a"\nauthorization_file = "word"\nmax_message_mb = 7\n'
        '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\nlink = "b"\n'
    )
    config = load(tmp_path / "config.toml")
    assert access_problems(config) == []
    assert secret(config.bridge("b"), "authorization") == WORD
    assert config.bridge("b").max_message_mb == 7


def test_a_config_that_anybody_can_change_is_reported(tmp_path: Path) -> None:
    config = replace(config_of("ws://a"), path=tmp_path / "in" / "config.toml")
    (tmp_path / "in").mkdir()
    config.path.touch(0o644)
    assert not [line for line in unsafe_places(config) if str(tmp_path) in line]
    config.path.chmod(0o646)
    (tmp_path / "in").chmod(0o777)
    found = list(unsafe_places(config))
    assert f"{config.path} is writable by everyone: chmod o-w {config.path}" in found
    assert any(f"{tmp_path / 'in'} is writable" in line for line in found)
    (tmp_path / "safe").mkdir()
    config.path.rename(tmp_path / "safe" / "config.toml")
    config.path.symlink_to(tmp_path / "safe" / "config.toml")
    config.path.chmod(0o644)
    found = list(unsafe_places(config))
    assert [line for line in found if str(tmp_path) in line] == [
        f"{tmp_path / 'in'} is writable by everyone: chmod o-w {tmp_path / 'in'}"
    ]
    (tmp_path / "in").chmod(0o1777)
    assert not any(f"{tmp_path / 'in'} is writable" in line for line in unsafe_places(config))


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
            frame = json.loads(await asyncio.wait_for(firsts.get(), 10))
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
    assert repeated == {".log", ".jsonl", ".gz"}


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
    """What is in a recording, also where it is not readable at once."""
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
