"""The real console in a terminal of its own, as its session's leader: what SSH or tmux start."""

import ctypes
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

from fleet_tui.ui.terminal.typing import GAP
from tests.support.invariants import log_is_whole
from tests.support.polling import HANGS

LIBC = ctypes.CDLL(None)
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE = 24, 1  # linux/prctl.h, linux/capability.h

SETTINGS = {"TERM": "xterm-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8", "PYTHONUTF8": "1"}


class InTerminal:
    """A program whose bytes are read as soon as they come, until told otherwise."""

    def __init__(self, arguments: list[str], home: Path, largest_file: int = 0, **more: str) -> None:
        self.home, self.largest_file = home, largest_file
        self.master, slave = pty.openpty()
        self.forget()
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

    def press_later(self, keys: str) -> None:
        """Press keys that begin anew: what follows typed text at once is part of it."""
        time.sleep(GAP + 0.1)
        self.press(keys)

    def forget(self) -> None:
        """Look at what comes from now on alone, as another terminal would that takes over."""
        self.sent = b""
        """Everything the program sent."""
        self._drawn = 0
        """How many of these bytes are on the screen."""
        self._screen = pyte.Screen(120, 40)
        self._stream = pyte.ByteStream(self._screen)

    def text(self) -> str:
        """The text on a terminal of 120x40 that received all these bytes."""
        sent = self.sent
        self._stream.feed(sent[self._drawn :])
        self._drawn = len(sent)
        # Not Screen.display, which fails at half a wide character: so it is between two reads.
        rows = (self._screen.buffer[y] for y in range(40))
        return "\n".join("".join(row[x].data for x in range(120)) for row in rows)

    def shows(self, text: str, within: float = HANGS) -> None:
        self.until(lambda: text in self.text(), within, text)

    def until(self, holds: Callable[[], object], within: float = HANGS, what: str = "") -> float:
        """Seconds until it holds."""
        begun = time.monotonic()
        while not holds():
            if time.monotonic() - begun > within:
                raise AssertionError(f"never: {what}\n{self.text()}")
            time.sleep(0.05)
        return time.monotonic() - begun

    def ends(self, within: float = HANGS) -> float:
        """Seconds until the process has ended."""
        begun = time.monotonic()
        self.child.wait(within)
        return time.monotonic() - begun

    def is_restored(self) -> bool:
        """Tell whether the terminal is restored: its modes, the first screen, the cursor, no mouse."""
        left = [self.sent.rfind(sequence) for sequence in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?1000l")]
        taken = [self.sent.rfind(sequence) for sequence in (b"\x1b[?1049h", b"\x1b[?25l", b"\x1b[?1000h")]
        was_taken = any(place >= 0 for place in taken)
        given_back = not was_taken or all(map(int.__gt__, left, taken))
        return termios.tcgetattr(self.slave)[:4] == self.cooked[:4] and given_back

    def children(self) -> list[int]:
        """The processes that its threads have started and that live."""
        found: list[int] = []
        for path in Path(f"/proc/{self.child.pid}/task").glob("*/children"):
            with suppress(FileNotFoundError):  # of a thread that has ended meanwhile
                found += map(int, path.read_text().split())
        return found

    def loses_nothing(self) -> None:
        """It ends when told to, gives the terminal back, and its log is whole. After a kill nobody could
        give the terminal back, and one that has hung up has gone."""
        killed = self.child.poll() == -signal.SIGKILL
        if not (killed or self._hung_up):
            self.reads.set()
            if self.child.poll() is None:
                self.child.terminate()
            self.ends(5.0)
            self.until(self.is_restored, 5.0, "the terminal restored")
        assert b"Traceback" not in self.sent
        if not self.largest_file:  # where no file can grow no line is whole
            log_is_whole(self.home, killed)

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
    # Where tests run as root: permissions hold for the program as for anybody.
    LIBC.prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0)
    os.setsid()
    fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
    if largest_file:
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))


@contextmanager
def in_terminal(home: Path, *arguments: str, largest_file: int = 0, **more: str) -> Iterator[InTerminal]:
    """The console, which has lost nothing in the end. Writing fails beyond `largest_file` bytes."""
    running = InTerminal(list(arguments), home, largest_file, **more)
    try:
        yield running
        running.loses_nothing()
    finally:
        running.close()


def exists(pid: int) -> bool:
    """Tell whether a process is running; a zombie is not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False
