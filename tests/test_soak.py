"""Twelve seconds of the soak (`make soak MINUTES=...` runs longer): nothing grows."""

import pytest

from tests.bench.soak import growth, soak

pytestmark = pytest.mark.nightly


def test_nothing_grows_while_100_robots_drive() -> None:
    samples, tasks = soak(12.0)
    third = len(samples) // 3
    # What leaks stays: it raises the least there is. The most is of what comes and goes within a second.
    for early, late in (
        ([one.threads for one in samples[:third]], [one.threads for one in samples[-third:]]),
        ([one.files for one in samples[:third]], [one.files for one in samples[-third:]]),
        (tasks[: len(tasks) // 3], tasks[-(len(tasks) // 3) :]),
    ):
        assert min(late) <= max(early)
    # Caches fill at first; one kept message in two would be more than this, however long one looks.
    assert growth(samples) < 20.0 or growth(soak(36.0)[0]) < 20.0
