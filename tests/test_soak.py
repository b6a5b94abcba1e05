"""Twelve seconds of the soak (`make soak MINUTES=...` runs longer): nothing grows."""

from tests.bench.soak import growth, soak


def test_nothing_grows_while_100_robots_drive() -> None:
    samples, tasks = soak(12.0)
    settled = samples[len(samples) // 3 :]
    assert max(one.threads for one in settled) <= max(one.threads for one in samples[:3])
    assert max(one.files for one in settled) <= max(one.files for one in samples[:3])
    assert max(tasks[len(tasks) // 3 :]) <= max(tasks[:5]) + 1  # a timer of Textual's may be between two
    # Caches fill at first; one kept message in two would be more than this.
    assert growth(samples) < 20.0
