"""Costs of the console: the spread of durations, and the memory of its process."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from fleet_tui.ui.terminal import budget
from fleet_tui.ui.terminal.budget import KEPT, Durations, memory


def test_the_spread_is_that_of_the_last_durations() -> None:
    durations = Durations()
    assert durations.spread() is None
    durations.take(99.0)
    for n in range(KEPT):
        durations.take(float(n))
    assert durations.spread() == (50.0, 95.0, 99.0)
    durations.take(0.0)
    assert durations.spread() == (50.0, 95.0, 99.0), "the first ones are forgotten"


def test_work_is_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    ticks = iter([1.0, 1.25])
    monkeypatch.setattr(budget, "time", SimpleNamespace(perf_counter=lambda: next(ticks)))
    durations, done = Durations(), list[int]()
    durations.timed(lambda: done.append(1))
    assert done == [1] and durations.spread() == (0.25, 0.25, 0.25)


def test_memory_has_a_maximum_above_what_it_is() -> None:
    found = memory()
    assert found is not None and 2**20 < found[0] <= found[1] < 2**34


def test_without_proc_memory_is_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: object, **__: object) -> str:
        raise FileNotFoundError

    monkeypatch.setattr(Path, "read_text", missing)
    assert memory() is None
    monkeypatch.setattr(Path, "read_text", lambda *_: "Name: x\nVmRSS: 7 kB\n\n")
    assert memory() is None
