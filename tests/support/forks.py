"""Tests side by side, collected once: each worker is a fork of the process that has collected them.

A plugin of pytest. pytest-xdist's workers each import and collect everything.
"""

import multiprocessing
import os
import random
import signal
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.sharedctypes import Synchronized
from typing import Any

import pytest
from _pytest.capture import CaptureManager
from _pytest.tmpdir import TempPathFactory

FORK = multiprocessing.get_context("fork")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--forks", type=int, default=0, help="how many tests run at once, each in a fork")


def pytest_runtestloop(session: pytest.Session) -> bool | None:
    count: int = session.config.option.forks
    if not count or session.config.option.collectonly or session.testsfailed:
        return None  # pytest's own loop, which says what failed to be collected
    taken: Synchronized[int] = FORK.Value("i", 0)
    workers = dict(_start(session, taken, number, None) for number in range(count))
    while workers:
        for reports in wait(list(workers)):
            assert isinstance(reports, Connection)
            worker = workers[reports]
            try:
                worker.tell(reports.recv())
            except EOFError:
                del workers[reports]
                if worker.has_crashed() and not session.shouldfail:
                    workers.update([_start(session, taken, worker.number, worker.following)])
        if session.shouldfail:
            taken.value = len(session.items)
    if session.shouldfail:
        raise session.Failed(session.shouldfail)
    return True


def _start(
    session: pytest.Session, taken: "Synchronized[int]", number: int, first: int | None
) -> "tuple[Connection, _Worker]":
    reports, ours = FORK.Pipe(duplex=False)
    process = FORK.Process(target=_run, args=(session, taken, number, first, ours))
    process.start()
    ours.close()  # the worker's alone: it ends with it
    return reports, _Worker(session, process, number)


class _Worker:
    """A fork as its parent sees it."""

    def __init__(self, session: pytest.Session, process: Any, number: int) -> None:
        self._session = session
        self._process = process
        self.number = number
        self._runs: pytest.Item | None = None
        self.following: int | None = None

    def tell(self, said: tuple[int, int | None] | dict[str, Any] | None) -> None:
        """Pass on a report; the places of the test that begins and its next one; or that one has ended."""
        hook = self._session.config.hook
        if isinstance(said, dict):
            report = hook.pytest_report_from_serializable(config=self._session.config, data=said)
            self._session.ihook.pytest_runtest_logreport(report=report)
        elif said is None:
            self._runs = None
        else:
            place, self.following = said
            self._runs = item = self._session.items[place]
            item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)

    def has_crashed(self) -> bool:
        """Wait for its end; a test in which it ended has failed."""
        self._process.join()
        item = self._runs
        if item is None:
            return False
        text = f"the process ended in this test, with {self._process.exitcode}"
        report = pytest.TestReport(item.nodeid, item.location, {}, "failed", text, "call")
        item.ihook.pytest_runtest_logreport(report=report)
        return True


def _run(
    session: pytest.Session, taken: "Synchronized[int]", number: int, first: int | None, reports: Connection
) -> None:
    config = session.config
    plugins = config.pluginmanager
    plugins.unregister(name="terminalreporter")
    plugins.register(_Reporter(config, reports))
    capture = plugins.getplugin("capturemanager")
    assert isinstance(capture, CaptureManager)
    capture.stop_global_capturing()  # its files are its parent's and all the others'
    capture.start_global_capturing()
    temporary: TempPathFactory = config._tmp_path_factory  # type: ignore[attr-defined]  # pytest adds it
    temporary._basetemp = temporary.getbasetemp() / f"worker{number}"
    temporary._basetemp.mkdir(exist_ok=True)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    random.seed()
    places = _places(taken, _turns(session.items), first)
    place = next(places, None)
    while place is not None:
        following = next(places, None)
        reports.send((place, following))
        item = session.items[place]
        after = None if following is None else session.items[following]
        try:
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=after)
        except KeyboardInterrupt:  # its parent says so
            os._exit(128 + signal.SIGINT)
        reports.send(None)
        place = following
    reports.close()
    os._exit(0)  # its parent ends the session


def _turns(items: Sequence[pytest.Item]) -> list[list[int]]:
    """The places of the tests that a fork takes at a time: one, or all of a file that share what is dear."""
    turns: list[list[int]] = []
    for place, item in enumerate(items):
        if item.get_closest_marker("one_fork") and place and item.path == items[place - 1].path:
            turns[-1].append(place)
        else:
            turns.append([place])
    return turns


def _places(taken: "Synchronized[int]", turns: Sequence[list[int]], first: int | None) -> Iterator[int]:
    """The places of the tests of one fork: first those that one which has ended had taken."""
    for turn in turns:
        if first in turn:
            yield from turn[turn.index(first) :]
    while True:
        with taken.get_lock():
            number = taken.value
            taken.value += 1
        if number >= len(turns):
            return
        yield from turns[number]


class _Reporter:
    """In a worker: what its tests gave."""

    def __init__(self, config: pytest.Config, reports: Connection) -> None:
        self._config = config
        self._reports = reports

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        hook = self._config.hook
        self._reports.send(hook.pytest_report_to_serializable(config=self._config, report=report))
