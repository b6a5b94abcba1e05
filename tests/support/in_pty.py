"""Real processes for the benchmarks: a console in a pty, a server beside it."""

import fcntl
import os
import pty
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pyte

from fleet_tui.ui.terminal.typing import GAP
from tests.support.polling import HANGS

WIDTH, HEIGHT = 200, 60
FOREIGN = ("NO_COLOR", "COLUMNS", "LINES", "TMUX")
"""Variables of the terminal in which this runs."""
TICKS_PER_SECOND = os.sysconf("SC_CLK_TCK")


class Terminal:
    """A program in a pty of 200 x 60, whose bytes are read as soon as they come."""

    def __init__(self, command: list[str], home: Path) -> None:
        self._master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", HEIGHT, WIDTH, 0, 0))
        self.chunks: list[tuple[float, bytes]] = []
        """The output with its times (monotonic)."""
        self._played = 0
        self._screen = pyte.Screen(WIDTH, HEIGHT)
        self._stream = pyte.ByteStream(self._screen)
        self.started = time.monotonic()
        self._child = subprocess.Popen(
            command, stdin=slave, stdout=slave, stderr=slave, start_new_session=True, env=_plain_env(home)
        )
        os.close(slave)
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    @property
    def pid(self) -> int:
        return self._child.pid

    def _read(self) -> None:
        while True:
            try:
                data = os.read(self._master, 65536)
            except OSError:
                return
            if not data:
                return
            self.chunks.append((time.monotonic(), data))

    def press(self, key: str) -> float:
        """Press a key; when that was."""
        at = time.monotonic()
        os.write(self._master, key.encode())
        return at

    def press_later(self, key: str) -> float:
        """Press a key that begins anew: what follows typed text at once is part of it."""
        time.sleep(GAP + 0.1)
        return self.press(key)

    def text(self) -> str:
        """The text on the terminal."""
        until = len(self.chunks)
        for _, data in self.chunks[self._played : until]:
            self._stream.feed(data)
        self._played = until
        # Not Screen.display, which fails at half a wide character: so it is between two chunks.
        rows = (self._screen.buffer[y] for y in range(HEIGHT))
        return "\n".join("".join(row[x].data for x in range(WIDTH)) for row in rows)

    def wait_for(self, text: str, within: float = HANGS) -> None:
        end = time.monotonic() + within
        while text not in self.text():
            has_ended = self._child.poll() is not None
            self._reader.join(1.0 if has_ended else 0.0)  # what it wrote last is still on its way
            if text not in self.text() and (has_ended or time.monotonic() > end):
                raise TimeoutError(f"never seen: {text}\n{self.text()}")
            time.sleep(0.05)

    def first_seen(self, text: bytes, within: float = HANGS) -> float:
        """Seconds from the start to the chunk with which these bytes have come."""
        end = time.monotonic() + within
        while time.monotonic() < end:
            found = b""
            for at, data in self.chunks[:]:
                found += data
                if text in found:
                    return at - self.started
            time.sleep(0.01)
        raise TimeoutError(f"never seen: {text!r}")

    def cpu(self) -> tuple[float, float]:
        """Seconds of CPU so far: of the main thread, of the process."""
        return _spent(f"/proc/{self.pid}/task/{self.pid}/stat"), _spent(f"/proc/{self.pid}/stat")

    def megabytes(self) -> float:
        """VmRSS in 10^6 bytes."""
        status = Path(f"/proc/{self.pid}/status").read_text()
        return int(status.partition("VmRSS:")[2].split()[0]) * 1024 / 1e6

    def close(self, key: str = "q") -> None:
        """Leave by a key, and kill what does not go."""
        if self._child.poll() is None:
            self.press(key)
        try:
            self._child.wait(10)
        except subprocess.TimeoutExpired:
            self._child.kill()
            self._child.wait()
        self._reader.join(2)
        os.close(self._master)


def shows_racks(terminal: Terminal) -> bool:
    """Tell if the map on the screen is one of the large ones made here: rows of racks as wide as the hall."""
    inside = [line[15:90] for line in terminal.text().splitlines()]
    return sum(sum("\u2580" <= cell <= "\u259f" for cell in row) > 60 for row in inside) >= 15


def _plain_env(home: Path) -> dict[str, str]:
    """A terminal with everything; no settings of the person who runs this."""
    env = {name: value for name, value in os.environ.items() if name not in FOREIGN}
    env |= {"TERM": "xterm-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8"}
    return env | {"XDG_CONFIG_HOME": str(home), "XDG_STATE_HOME": str(home), "PYTHONUTF8": "1"}


def _spent(stat: str) -> float:
    fields = Path(stat).read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS_PER_SECOND


@contextmanager
def serving(*args: str) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """A Python module that announces a URL on its first line and ends with its standard input."""
    with subprocess.Popen(
        [sys.executable, "-m", *args],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    ) as child:
        assert child.stdout is not None
        try:
            yield child.stdout.readline().decode().strip(), child
        finally:
            child.terminate()


@contextmanager
def simulator(robots: int, rate: float = 10.0, kind: str = "oh_ressources") -> Iterator[str]:
    """The simulator's URL: all robots on one floor."""
    counts = ["--robots", str(robots), "--floors", "1", "--rate", str(rate), "--kind", kind]
    with serving("fleet_tui", "sim", "--port", "0", "--stop-with-stdin", *counts) as (url, _):
        yield url


@contextmanager
def console(
    url: str,
    robots: int,
    probe: list[str] | None = None,
    floor_map: Path | None = None,
    kind: str = "oh_ressources",
    names: Sequence[str] = (),
) -> Iterator[Terminal]:
    """The console with one floor on a server; `probe`: started with these arguments of probe.py; `names` of
    the robots, if not the usual ones."""
    with tempfile.TemporaryDirectory() as folder:
        config = Path(folder) / "config.toml"
        shown = names or [f"robot_{n}" for n in range(robots)]
        entries = "".join(f'[[robots]]\nname = "{name}"\n' for name in shown)
        map_line = f'map = "{floor_map}"\n' if floor_map else ""
        profile = f'[profile]\nkind = "{kind}"\n'
        config.write_text(
            f'{profile}[rosbridge]\nurl = "{url}"\n[[floors]]\nname = "floor_0"\n{map_line}{entries}'
        )
        start = ["tests.bench.probe", *probe, "--"] if probe else ["fleet_tui"]
        terminal = Terminal([sys.executable, "-m", *start, "--config", str(config)], Path(folder))
        try:
            yield terminal
        finally:
            terminal.close()
