"""A real broker for tests: mosquitto on a free port, that can be killed, restarted and frozen."""

import json
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

PROGRAM = shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin:/usr/bin:/usr/local/bin")
needs_mosquitto = pytest.mark.skipif(PROGRAM is None, reason="mosquitto is not installed")
ANYONE = ("allow_anonymous true",)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


class Mosquitto:
    """A broker with these lines in its configuration, besides its listener."""

    def __init__(self, folder: Path, lines: tuple[str, ...] = ANYONE) -> None:
        self.port = free_port()
        self._file = folder / f"mosquitto_{self.port}.conf"
        self._file.write_text("\n".join([f"listener {self.port} 127.0.0.1", *lines, "user root", ""]))
        self._log = folder / f"mosquitto_{self.port}.log"
        self._process: subprocess.Popen[bytes] | None = None
        self.start()

    @property
    def url(self) -> str:
        return f"mqtt://127.0.0.1:{self.port}"

    @property
    def log(self) -> str:
        return self._log.read_text(errors="replace")

    def start(self) -> None:
        """Start it, and wait until it listens."""
        assert PROGRAM is not None
        with self._log.open("ab") as log:
            command = [PROGRAM, "-v", "-c", str(self._file)]
            self._process = subprocess.Popen(command, stdout=log, stderr=log)
        until = time.monotonic() + 10
        while True:
            assert self._process.poll() is None, self.log
            with suppress(OSError), socket.create_connection(("127.0.0.1", self.port), 1):
                return
            assert time.monotonic() < until, self.log
            time.sleep(0.01)

    def _signal(self, number: int) -> None:
        if self._process is not None:
            self._process.send_signal(number)

    def freeze(self) -> None:
        self._signal(signal.SIGSTOP)

    def thaw(self) -> None:
        self._signal(signal.SIGCONT)

    def kill(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None


@contextmanager
def mosquitto(folder: Path, *lines: str) -> Iterator[Mosquitto]:
    """A broker that ends with the test."""
    broker = Mosquitto(folder, lines or ANYONE)
    try:
        yield broker
    finally:
        broker.kill()


def refusing(folder: Path, pattern: str) -> tuple[str, ...]:
    """The lines for a broker that refuses these subscriptions."""
    plugin = next(Path("/usr/lib").rglob("mosquitto_dynamic_security.so"), None)
    if plugin is None:
        pytest.skip("mosquitto's dynamic security is not installed")
    refused = {"acltype": "subscribePattern", "topic": pattern, "allow": False, "priority": 1}
    allowed = {"acltype": "subscribePattern", "topic": "#", "allow": True, "priority": 0}
    access = {name: name.startswith("unsub") for name in ("publishClientSend", "subscribe", "unsubscribe")}
    content = {
        "defaultACLAccess": {**access, "publishClientReceive": True},
        "anonymousGroup": "anyone",
        "groups": [{"groupname": "anyone", "roles": [{"rolename": "watcher"}]}],
        "roles": [{"rolename": "watcher", "acls": [refused, allowed]}],
    }
    file = folder / "roles.json"
    file.write_text(json.dumps(content))
    return (*ANYONE, f"plugin {plugin}", f"plugin_opt_config_file {file}")
