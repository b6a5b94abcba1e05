"""Time of a test: it stands still while anything computes, and jumps to what is due next once all wait.

A plugin of pytest. While a test runs in an asyncio loop, seconds pass for nothing else: not for a machine
that is busy, not for a test that waits. Two kinds of test have real seconds: those that run no loop, and
those with another process, from its start on, unless that only answers, as a broker does.
"""

import asyncio
import concurrent.futures.thread
import fcntl
import gc
import math
import os
import queue
import select
import selectors
import socket
import subprocess
import sys
import termios
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from typing import Any

import pytest

_monotonic, _time, _sleep, _wait = time.monotonic, time.time, time.sleep, threading.Condition.wait
_join = threading.Thread.join

LOOK, REAL_LOOK = 0.002, 0.02
"""Seconds of the machine between two looks at whether all wait; and at whether time stands, while it runs."""

GLANCE = 1e-6
"""Seconds that pass with each look at the time: what is done later has a later time."""

POOLED = concurrent.futures.thread._threads_queues
"""The threads of executors."""
IDLE = concurrent.futures.thread._worker.__code__
"""What one of them does that has nothing to do."""

FAR, QUIET = 0.5, 10
"""A leap of more seconds than that waits for so many looks: on a busy machine what one end of a connection
has sent may not have reached the other."""
LOST = 1.0
"""Seconds of the machine for which no time passes while something is under way, unless that gets less: a peer
may read nothing any more."""
PAHO = "paho/mqtt/client.py"
"""The code of a client of MQTT whose loop is its own."""
SYN_SENT = 2
"""The state of a socket of TCP that waits for its peer's first word (RFC 9293)."""
PATIENCE = 50
"""Looks without any computing after which a thread that waits in an unknown way, as for a socket, holds
nobody up."""


class DrivenTime:
    """The clock of this process, and who waits for it until when: threads by their ident."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._ahead = self._led = 0.0  # of the machine's clocks: while time runs, and when they last agreed
        self._stands_at: float | None = None
        self._real = False
        self._loops = set[int]()
        self._due: dict[int, tuple[float, _Selector | None]] = {}
        self._computing = 0
        self._answering: list[int] = []
        self._unsent: list[dict[int, int]] = []
        self._unsent_at = 0.0
        # Not their idents: a new thread gets that of one that has ended.
        self._before = set[threading.Thread]()

    def monotonic(self) -> float:
        with self._lock:
            if self._stands_at is None:
                return _monotonic() + self._ahead
            self._stands_at += GLANCE
            return self._stands_at

    def time(self) -> float:
        return _time() - _monotonic() + self.monotonic() - self._led

    def time_ns(self) -> int:
        return int(self.time() * 1e9)

    def sleep(self, seconds: float) -> None:
        """As `time.sleep`."""
        looks = 0
        with self._waiting(self.monotonic() + seconds) as due:
            while (left := due - self.monotonic()) > 0:
                if self._stands_at is None:
                    _sleep(min(left, REAL_LOOK))
                elif not self._jump(looks := looks + 1):
                    _sleep(LOOK)

    def wait_for(self, condition: threading.Condition, seconds: float | None) -> bool:
        """As `threading.Condition.wait`."""
        if not self._drives(seconds):
            return _wait(condition, seconds)
        # Python's own wait for a nap, again and again, misses a notice that comes as the nap ends.
        waiter = threading.Lock()
        waiter.acquire()
        condition._waiters.append(waiter)  # type: ignore[attr-defined]  # typeshed has it not
        held, is_notified = condition._release_save(), False  # type: ignore[attr-defined]  # nor this
        try:
            is_notified = self._until(lambda nap: waiter.acquire(timeout=nap), seconds)
        finally:
            condition._acquire_restore(held)  # type: ignore[attr-defined]  # nor this
            if not is_notified:
                with suppress(ValueError):
                    condition._waiters.remove(waiter)  # type: ignore[attr-defined]  # nor this
        return is_notified

    def join(self, thread: threading.Thread, seconds: float | None) -> None:
        """As `threading.Thread.join`."""

        def has_ended(nap: float) -> bool:
            _join(thread, nap)
            return not thread.is_alive()

        if self._drives(seconds):
            self._until(has_ended, seconds)
        else:
            _join(thread, seconds)

    def _drives(self, seconds: float | None) -> bool:
        """Tell whether a thread that waits for another has driven seconds. One without a loop that waits for
        ever needs none."""
        ident = threading.get_ident()
        return (
            self._stands_at is not None
            and threading.current_thread() not in self._before
            and (ident in self._loops or seconds is not None)
        )

    def _until(self, holds: Callable[[float], bool], seconds: float | None) -> bool:
        looks = 0
        with self._waiting(math.inf if seconds is None else self.monotonic() + seconds) as due:
            while self.monotonic() < due:
                if holds(LOOK):
                    return True
                self._jump(looks := looks + 1)
        return False

    def begin_test(self) -> None:
        """Have seconds stand again: another process may have made them run."""
        self._real = False
        self._answering.clear()
        self._led = self.monotonic() - _monotonic()
        self._before = set(threading.enumerate())

    def be_real(self) -> None:
        """Have seconds run, to the end of this test: another process has no other."""
        with self._lock:
            self._real = True
            self._run()
            self._led = self._ahead

    def start_answering(self, command: list[str], **named: Any) -> "subprocess.Popen[bytes]":
        """Start a process for which time is nothing, as a broker: seconds stand while it computes."""
        process = subprocess.Popen.__new__(subprocess.Popen)
        _start(process, command, **named)
        self._answering.append(process.pid)
        return process

    def _run(self) -> None:
        if self._stands_at is not None:
            self._ahead, self._stands_at = self._stands_at - _monotonic(), None

    @contextmanager
    def loop_runs(self) -> Iterator[None]:
        ident, is_main = threading.get_ident(), threading.current_thread() is threading.main_thread()
        with self._lock:
            self._loops.add(ident)
            if is_main and not self._real and self._stands_at is None:
                self._stands_at = self.monotonic()
        try:
            yield
        finally:
            with self._lock:
                self._loops.remove(ident)
                if is_main:
                    self._run()

    @contextmanager
    def _waiting(self, due: float, selector: "_Selector | None" = None) -> Iterator[float]:
        ident = threading.get_ident()
        with self._lock:
            self._due[ident] = due, selector
        try:
            yield due
        finally:
            with self._lock:
                del self._due[ident]

    def computes(self, future: "asyncio.Future[Any]") -> None:
        """Hold time until a thread has done what a loop waits for."""
        with self._lock:
            self._computing += 1
        future.add_done_callback(self._has_computed)

    def _has_computed(self, _future: "asyncio.Future[Any]") -> None:
        with self._lock:
            self._computing -= 1

    def wait(self, selector: "_Selector", seconds: float | None) -> list[tuple[selectors.SelectorKey, int]]:
        """Return what a loop waits for: what has come, or nothing once the time is over."""
        looks, used = 0, 0.0
        with self._waiting(math.inf if seconds is None else self.monotonic() + seconds, selector) as due:
            while True:
                stands = self._stands_at is not None
                if stands:
                    self._jump(looks)
                left = due - self.monotonic()
                ready = selector.look(0.0 if left <= 0 else LOOK if stands else min(left, REAL_LOOK))
                if ready or left <= 0:
                    return ready
                before, used = used, time.process_time()
                looks = looks + 1 if used - before < LOOK / 10 else 0

    def _jump(self, looks: int) -> bool:
        """Move to the first moment for which somebody waits, if all wait; tell whether time passed. `looks`:
        those of this thread in which nothing has come."""
        with self._lock:
            if self._stands_at is None or not self._loops <= self._due.keys():
                return False
            first = min(due for due, _ in self._due.values())
            if first == math.inf or any(map(self._is_called, self._due.values())):
                return False
            if first > self._stands_at + FAR and looks < QUIET:
                return False
            # What it has been sent has woken it: asleep it has answered.
            if self._is_under_way() or any(_computes(f"/proc/{pid}") for pid in self._answering):
                return False
            if not self._nothing_computes() and (looks < PATIENCE or _others_could_run()):
                return False
            self._stands_at = max(self._stands_at, first) + GLANCE
            for due, loop in self._due.values():
                if loop and due <= self._stands_at:
                    loop.wake()
            return True

    def _is_under_way(self) -> bool:
        loops = [loop for _, loop in self._due.values() if loop]
        unsent = [loop.unsent() for loop in loops]
        if any(unsent):
            for loop in loops:
                loop.acknowledge()
        if unsent != self._unsent:
            self._unsent, self._unsent_at = unsent, _monotonic()
        return any(unsent) and _monotonic() - self._unsent_at < LOST

    def _is_called(self, waits: tuple[float, "_Selector | None"]) -> bool:
        """Tell whether a thread is about to wake."""
        due, loop = waits
        assert self._stands_at is not None
        return loop.has_news() if loop else due <= self._stands_at

    def _nothing_computes(self) -> bool:
        threads, frames = threading.enumerate(), _frames()
        at_work = [one for one in threads if one in POOLED and not _is_idle(frames.get(one.ident or 0))]
        is_done = self._computing <= len(at_work)
        return is_done and all(self._waits(one, frames.get(one.ident or 0)) for one in threads)

    def _waits(self, thread: threading.Thread, frame: FrameType | None) -> bool:
        """Tell whether a thread without a loop does nothing: it waits for another, or was there before."""
        ident = thread.ident
        if ident is None:  # it is about to begin
            return False
        if thread in self._before or ident in self._due or ident == threading.get_ident():
            return True
        if frame is not None and frame.f_code is _wait.__code__:
            waiter = frame.f_locals.get("waiter")
            return waiter is not None and waiter.locked()
        if frame is not None and frame.f_code.co_filename.endswith(PAHO) and frame.f_code.co_name == "_loop":
            return _has_nothing(frame.f_locals)
        return frame is None or frame.f_code is IDLE or frame.f_code.co_filename == selectors.__file__


def _has_nothing(waits: Mapping[str, Any]) -> bool:
    """Tell whether a client of MQTT, in its own thread, waits for its sockets, and nothing is there."""
    try:
        is_ready = any(map(any, select.select(waits["rlist"], waits["wlist"], [], 0)))
        return not is_ready and not _outgoing(waits["rlist"][0].fileno())
    except (KeyError, OSError, ValueError):  # it has not come so far, or its socket has been closed
        return False


def _others_could_run() -> bool:
    """Tell whether a thread computes, or would if a busy machine let it, or waits for the name service, which
    answers in the machine's time."""
    asks = any(frame.f_code is socket.getaddrinfo.__code__ for frame in _frames().values())
    return asks or any(map(_could_run, threading.enumerate()))


def _could_run(thread: threading.Thread) -> bool:
    is_new = thread.native_id is None
    is_other = thread is not threading.current_thread()
    return is_new or (is_other and _computes(f"/proc/self/task/{thread.native_id}"))


def _computes(task: str) -> bool:
    """Tell whether a process or thread runs, or would if a busy machine let it. One that was interrupted as
    it was about to sleep is asleep by its state, and `running` in its call of the system."""
    try:
        state = Path(task, "stat").read_text().rpartition(") ")[2][0]
        return state in "RD" or (state == "S" and Path(task, "syscall").read_text().startswith("running"))
    except OSError:  # it has ended
        return False


def _frames() -> dict[int, FrameType]:
    """Return what threads do, by their ident; Python has no other way in. Python 3.11 stands for ever if
    it collects garbage meanwhile and another thread begins or ends (gh-106883)."""
    collects = gc.isenabled()
    gc.disable()
    try:
        return sys._current_frames()
    finally:
        if collects:
            gc.enable()


def _outgoing(descriptor: int) -> int:
    return int.from_bytes(fcntl.ioctl(descriptor, termios.TIOCOUTQ, bytes(4)), sys.byteorder)


def _unsent(key: selectors.SelectorKey) -> int:
    """Return how many bytes are between a socket and its peer; the wish for a connection is one."""
    try:
        count = _outgoing(key.fd)
        if count or not key.events & selectors.EVENT_WRITE:
            return count
        with socket.socket(fileno=os.dup(key.fd)) as same:
            return same.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, 1)[0] == SYN_SENT
    except OSError:  # no socket, or none of TCP
        return 0


def _is_idle(frame: FrameType | None) -> bool:
    return frame is not None and frame.f_code is IDLE


class _Selector(selectors.EpollSelector):
    """One that a jump in time wakes."""

    def __init__(self) -> None:
        super().__init__()
        self._is_woken = False
        self._jumped = os.eventfd(0, os.EFD_NONBLOCK | os.EFD_CLOEXEC)
        self._epoll: select.epoll = self._selector  # type: ignore[attr-defined]  # typeshed has it not
        self._epoll.register(self._jumped, select.EPOLLIN)
        self._news = select.poll()
        self._news.register(self._epoll.fileno(), select.POLLIN)

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        ready = self.look(0.0)
        return ready if ready or (timeout is not None and timeout <= 0) else TIME.wait(self, timeout)

    def look(self, seconds: float) -> list[tuple[selectors.SelectorKey, int]]:
        ready = super().select(seconds)
        if self._is_woken:
            self._is_woken = False
            with suppress(BlockingIOError):  # a thread that wakes it once more now has its news read already
                os.eventfd_read(self._jumped)
        return ready

    def has_news(self) -> bool:
        """Tell whether its loop has something to do that it has not seen yet. From any thread."""
        return bool(self._news.poll(0))

    def unsent(self) -> dict[int, int]:
        """Return what it has written that has not reached its peer, by descriptor. From any thread."""
        return {key.fd: count for key in list(self.get_map().values()) if (count := _unsent(key))}

    def acknowledge(self) -> None:
        """Tell its peers what has reached it: by itself the kernel takes up to 40 ms. From any thread."""
        for key in list(self.get_map().values()):
            with suppress(OSError), socket.socket(fileno=os.dup(key.fd)) as same:
                same.setsockopt(socket.IPPROTO_TCP, socket.TCP_QUICKACK, 1)

    def wake(self) -> None:
        os.eventfd_write(self._jumped, 1)
        self._is_woken = True

    def close(self) -> None:
        super().close()
        os.close(self._jumped)


class _Loop(asyncio.SelectorEventLoop):
    def __init__(self) -> None:
        self._driven = _Selector()
        super().__init__(self._driven)

    def run_forever(self) -> None:
        with TIME.loop_runs():
            super().run_forever()

    def run_in_executor(  # type: ignore[override]  # typeshed's types for it need its own names
        self, executor: Any, func: Callable[..., Any], *args: Any
    ) -> "asyncio.Future[Any]":
        future = super().run_in_executor(executor, func, *args)
        TIME.computes(future)
        return future


class _Policy(asyncio.DefaultEventLoopPolicy):
    def new_event_loop(self) -> asyncio.AbstractEventLoop:
        return _Loop()


TIME = DrivenTime()
_start = subprocess.Popen.__init__


def _starts(process: "subprocess.Popen[Any]", *arguments: Any, **named: Any) -> None:
    TIME.be_real()
    _start(process, *arguments, **named)


def _waits(condition: threading.Condition, timeout: float | None = None) -> bool:
    return TIME.wait_for(condition, timeout)


def _joins(thread: threading.Thread, timeout: float | None = None) -> None:
    TIME.join(thread, timeout)


for _owner, _name, _ours in (
    (time, "monotonic", TIME.monotonic),
    (threading, "_time", TIME.monotonic),
    (queue, "time", TIME.monotonic),
    (time, "time", TIME.time),
    (time, "time_ns", TIME.time_ns),
    (time, "sleep", TIME.sleep),
    (threading.Condition, "wait", _waits),
    (threading.Thread, "join", _joins),
    (subprocess.Popen, "__init__", _starts),
):
    setattr(_owner, _name, _ours)
os.register_at_fork(before=TIME.be_real)
asyncio.set_event_loop_policy(_Policy())


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    TIME.begin_test()
