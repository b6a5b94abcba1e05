"""Work beside a disk: repeated, woken, ended; it survives mistakes, and holds nobody up."""

import threading

import pytest

from fleet_tui.storage.worker import Worker
from tests.support.polling import eventually

LONG = 1000.0


def test_it_does_a_step_at_once_one_whenever_it_is_woken_and_then_the_end() -> None:
    done, step = list[str](), threading.Semaphore(0)

    def work() -> None:
        done.append("step")
        step.release()

    worker = Worker("test", work, LONG, lambda: done.append("end"))
    worker.start()
    assert step.acquire(timeout=30)
    worker.wake()
    assert step.acquire(timeout=30)
    assert worker.close(30.0) and not worker.is_running
    assert done == ["step", "step", "end"]


def test_a_mistake_costs_its_step_alone(caplog: pytest.LogCaptureFixture) -> None:
    done, step = list[str](), threading.Semaphore(0)

    def work() -> None:
        done.append("step")
        step.release()
        raise ValueError("a mistake")

    worker = Worker("test", work, LONG, lambda: done.append("end"))
    worker.start()
    assert step.acquire(timeout=30)
    worker.wake()
    assert step.acquire(timeout=30)
    assert worker.close(30.0)
    assert done == ["step", "step", "end"] and caplog.text.count("a mistake") >= 2


def test_what_hangs_is_known_and_not_waited_for() -> None:
    begun, answers, done = threading.Event(), threading.Event(), list[str]()

    def work() -> None:
        begun.set()
        answers.wait(60)

    worker = Worker("test", work, LONG, lambda: done.append("end"))
    assert worker.busy_for == 0.0
    worker.start()
    assert begun.wait(30)
    assert worker.busy_for > 0.0
    eventually(lambda: not worker.waits_for_processor)
    assert not worker.close(0.01) and worker.is_running and done == []
    answers.set()
    assert worker.close(30.0) and done == ["end"] and worker.busy_for == 0.0
