"""Waiting for a discovery: a line of progress on a terminal alone, and it is erased."""

import os
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from types import SimpleNamespace
from typing import Any

import pytest

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery import awaiting
from fleet_tui.links.discovery.awaiting import Discovering
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message

SITE = DiscoveredSite(Link("ws://a:9090"), {}, {}, 7)


class Begun:
    """A discovery that a test ends."""

    def __init__(self) -> None:
        self.future: Future[DiscoveredSite] = Future()
        self.watch: Callable[[int, int, str], object] = lambda *_: None

    def start(self, _bridge: Link, _within: float, watch: Callable[[int, int, str], object]) -> Any:
        self.watch = watch
        return self.future


@pytest.fixture
def begun(monkeypatch: pytest.MonkeyPatch) -> Begun:
    begun = Begun()
    monkeypatch.setattr(awaiting, "start_discovery", begun.start)
    return begun


def show_twice(begun: Begun, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let time pass: progress, then the end."""
    told: Iterator[Callable[[], object]] = iter(
        [lambda: begun.watch(3, 9, "asking"), lambda: begun.future.set_result(SITE)]
    )

    def wait(_futures: object, seconds: float) -> None:
        if seconds:
            next(told)()

    monkeypatch.setattr(awaiting, "wait", wait)


@pytest.mark.parametrize("is_terminal", [True, False])
def test_progress_is_shown_on_a_terminal_and_erased(
    begun: Begun, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], is_terminal: bool
) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: is_terminal)
    monkeypatch.setattr(os, "get_terminal_size", lambda _fd: SimpleNamespace(columns=30))
    show_twice(begun, monkeypatch)
    assert Discovering(Link("ws://ana:hush@a:9090")).result() is SITE
    shown = capsys.readouterr().err
    assert "hush" not in shown
    if is_terminal:
        assert "ws://***@a:9090: asking 3 of 9"[:29] in shown and shown.endswith("\r\x1b[K")
    else:
        assert shown == ""


def test_an_error_is_that_of_the_discovery(begun: Begun, capsys: pytest.CaptureFixture[str]) -> None:
    begun.future.set_exception(LinkError(Message("connection refused")))
    with pytest.raises(LinkError, match="connection refused"):
        Discovering(Link("ws://a:9090")).result()
    assert capsys.readouterr().err == ""


def test_ctrl_c_ends_the_discovery(begun: Begun, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(awaiting, "wait", interrupted)
    with pytest.raises(KeyboardInterrupt):
        Discovering(Link("ws://a:9090")).result()
    assert begun.future.cancelled()
