"""Exit despite anything that hangs: a terminal that is not read, a name lookup of half a minute."""

import os
import select
import signal
import sys
import termios
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

PATIENCE = 1.0
"""Seconds for an orderly exit. After a signal the process ends within 2."""

LOOK_EVERY = 0.5
"""Seconds between two checks whether the terminal still exists."""

# Leave Textual's screen: no mouse, no focus events, no bracketed paste, first screen, plain, cursor.
_LEAVE = b"\x1b[?1000l\x1b[?1003l\x1b[?1006l\x1b[?1004l\x1b[?2004l\x1b[<u\x1b[?1049l\x1b[m\x1b[?25h"


def end_within(seconds: float, code: int, restore: Callable[[], None] = lambda: None) -> None:
    """End the process after a number of seconds, unless it has ended by itself."""

    def end() -> None:
        restore()
        os._exit(code)

    timer = threading.Timer(seconds, end)
    timer.daemon = True
    timer.start()


def terminal_restorer() -> Callable[[], None]:
    """Return a function that restores the terminal's current state, without waiting for a reader."""
    try:
        descriptor = sys.stdout.fileno()
        modes = termios.tcgetattr(descriptor)
    except (OSError, ValueError, termios.error):
        return lambda: None

    def restore() -> None:
        threading.excepthook = lambda _: None  # a write at this moment is cut off
        with suppress(OSError, termios.error):
            termios.tcsetattr(descriptor, termios.TCSANOW, modes)
            os.set_blocking(descriptor, False)
            _leave(descriptor)
            os.set_blocking(descriptor, True)

    return restore


def _leave(descriptor: int) -> None:
    """Leave the screen, without waiting. Unread output is dropped."""
    for _ in range(10):
        # Wakes a writer blocked in the kernel, which would block every other one: this may not wait now.
        for action in (termios.TCOOFF, termios.TCOON):
            termios.tcflow(descriptor, action)
        termios.tcflush(descriptor, termios.TCOFLUSH)
        try:
            os.write(descriptor, _LEAVE)
        except BlockingIOError:
            time.sleep(0.01)
        else:
            break


def _is_hung_up(descriptor: int) -> bool:
    look = select.poll()
    look.register(descriptor, 0)
    return any(event & select.POLLHUP for _, event in look.poll(0))


def leave_on_signals(
    loop: "AbstractEventLoop", leave: Callable[[], object], restore: Callable[[], None]
) -> None:
    """Call `leave` on the loop on SIGTERM, SIGHUP and SIGINT; if that hangs, `restore` and end.

    The same if the terminal goes without a SIGHUP: only its own session gets one.
    """
    terminal = sys.__stdout__  # Textual has replaced the other one by now

    def on_signal(number: int, _frame: object) -> None:
        end_within(PATIENCE, 128 + number, restore)
        loop.call_soon_threadsafe(leave)

    def look() -> None:
        if terminal is not None and _is_hung_up(terminal.fileno()):
            on_signal(signal.SIGHUP, None)
        else:
            loop.call_later(LOOK_EVERY, look)

    for name in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT):
        signal.signal(name, on_signal)
    look()
