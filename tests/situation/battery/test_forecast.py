"""The guess of how long a battery lasts: only from a clear slope."""

import random
from collections.abc import Sequence

import pytest

from fleet_tui.situation.battery.forecast import forecast
from fleet_tui.situation.battery.history import BatterySample

Levels = Sequence[float]


def guess(
    levels: Levels, low: float = 20.0, late: float = 0.0, gap: int | None = None
) -> tuple[float, float | None] | None:
    """Minutes until it is empty and until it is low, of one level a minute."""
    samples = [BatterySample(60.0 * n, level, n not in (0, gap)) for n, level in enumerate(levels)]
    found = forecast(samples, low, samples[-1].at + late)
    if found is None:
        return None
    return round(found.empty_in / 60, 1), None if found.low_in is None else round(found.low_in / 60, 1)


FALLING = [80.0 - 0.5 * n for n in range(21)]


def test_a_steady_fall_is_continued() -> None:
    assert guess(FALLING) == (140.0, 100.0)
    assert guess([one - 60.0 for one in FALLING]) == (20.0, None), "it is low already"
    whole = [float(int(one)) for one in FALLING]
    found = guess(whole)
    assert found is not None and found[0] == pytest.approx(140.0, rel=0.1)


def test_outliers_change_little() -> None:
    chance = random.Random(1)
    noisy = [one + chance.uniform(-0.2, 0.2) for one in FALLING]
    noisy[7] -= 0.4
    found = guess(noisy)
    assert found is not None and found[0] == pytest.approx(140.0, rel=0.15)


@pytest.mark.parametrize(
    ("why", "levels"),
    [
        ("too short", FALLING[:9]),
        ("it stands", [80.0] * 30),
        ("it charges", FALLING[::-1]),
        ("it has just charged", [*FALLING, 75.0, 74.5, 74.0]),
        ("hardly a change", [80.0 - 0.05 * n for n in range(30)]),
        ("it fell at once and then stood", [80.0] * 10 + [70.0] * 10),
    ],
)
def test_nothing_is_said_without_a_clear_slope(why: str, levels: Levels) -> None:
    assert guess(levels) is None, why


def test_nothing_is_said_of_old_levels_or_across_a_gap() -> None:
    assert guess(FALLING, late=121.0) is None
    assert guess(FALLING, gap=15) is None and guess(FALLING, gap=5) is not None
    assert forecast([], 20.0, 0.0) is None


def test_only_the_last_half_hour_counts() -> None:
    changed = [100.0 - 2.0 * n for n in range(20)] + [60.0 - 0.2 * n for n in range(32)]
    found = guess(changed)
    assert found is not None and found[0] == pytest.approx((60 - 6.2) / 0.2, rel=0.05)
