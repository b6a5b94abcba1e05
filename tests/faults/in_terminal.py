"""The real console in a terminal of its own, as its session's leader: what SSH or tmux start."""

import fcntl
import os
import pty
import resource
import select
import signal
import struct
import subprocess
import sys
import termios
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pyte

SETTINGS = {"TERM": "xterm-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8", "PYTHONUTF8": "1"}


class InTerminal:
    """A program whose bytes are read as soon as they come, until told otherwise."""

    def __init__(self, arguments: list[str], home: Path, largest_file: int = 0, **more: str) -> None:
        self.master, slave = pty.openpty()
        self.sent = b""
        """Everything the program sent."""
        self.reads = threading.Event()
        self.reads.set()
        self._hung_up = False
        self.resize(120, 40)
        self.cooked = termios.tcgetattr(slave)
        own = {"HOME": str(home), "XDG_CONFIG_HOME": str(home), "XDG_STATE_HOME": str(home / "state")}
        self.child = subprocess.Popen(
            [sys.executable, "-m", "fleet_tui", *arguments],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            env={**_plain(), **SETTINGS, **own, **more},
            preexec_fn=lambda: _take_over(slave, largest_file),
        )
        self.slave = slave
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        with suppress(OSError):
            while not self._hung_up:
                if not self.reads.wait(0.05) or not select.select([self.master], [], [], 0.05)[0]:
                    continue
                self.sent += os.read(self.master, 65536)

    def hang_up(self) -> None:
        """Close this end. Nobody reads by then: another terminal may get the descriptor's number."""
        self._hung_up = True
        self._reader.join()
        for descriptor in (self.slave, self.master):
            os.close(descriptor)

    def resize(self, width: int, height: int) -> None:
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", height, width, 0, 0))

    def press(self, keys: str) -> None:
        os.write(self.master, keys.encode())

    def text(self, width: int = 120, height: int = 40) -> str:
        """What a terminal shows that got all these bytes."""
        screen = pyte.Screen(width, height)
        pyte.ByteStream(screen).feed(self.sent)
        return "\n".join(screen.display)

    def shows(self, text: str, within: float = 20.0) -> None:
        self.until(lambda: text in self.text(), within, text)

    def until(self, holds: Callable[[], object], within: float = 20.0, what: str = "") -> float:
        """Seconds until it holds."""
        begun = time.monotonic()
        while not holds():
            if time.monotonic() - begun > within:
                raise AssertionError(f"never: {what}\n{self.text()}")
            time.sleep(0.02)
        return time.monotonic() - begun

    def ends(self, within: float = 10.0) -> float:
        """Seconds until the process has ended."""
        begun = time.monotonic()
        self.child.wait(within)
        return time.monotonic() - begun

    def is_restored(self) -> bool:
        """Whether the terminal is as it was: its modes, the first screen, the cursor, no mouse."""
        left = [self.sent.rfind(sequence) for sequence in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?1000l")]
        taken = [self.sent.rfind(sequence) for sequence in (b"\x1b[?1049h", b"\x1b[?25l", b"\x1b[?1000h")]
        return termios.tcgetattr(self.slave)[:4] == self.cooked[:4] and all(map(int.__gt__, left, taken))

    def children(self) -> list[int]:
        """The processes it has started and that live."""
        found = Path(f"/proc/{self.child.pid}/task/{self.child.pid}/children").read_text().split()
        return [int(pid) for pid in found]

    def close(self) -> None:
        if self.child.poll() is None:
            with suppress(ProcessLookupError):
                self.child.send_signal(signal.SIGKILL)
            self.child.wait(10)
        if not self._hung_up:
            self.hang_up()


def _plain() -> dict[str, str]:
    """Without what says how large or how colourful a terminal is."""
    return {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "LINES", "NO_COLOR")}


def _take_over(slave: int, largest_file: int) -> None:
    os.setsid()
    fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
    if largest_file:
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))


@contextmanager
def in_terminal(home: Path, *arguments: str, largest_file: int = 0, **more: str) -> Iterator[InTerminal]:
    """The console, killed at the end if it still runs. Writing fails beyond `largest_file` bytes."""
    running = InTerminal(list(arguments), home, largest_file, **more)
    try:
        yield running
    finally:
        running.close()


def exists(pid: int) -> bool:
    """Whether a process lives; one that has ended and is not yet reaped does not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False
