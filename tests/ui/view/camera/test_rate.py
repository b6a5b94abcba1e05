"""The rate of pictures: halved above the limit, and back below it."""

import pytest

from fleet_tui.ui.view.camera.caption import EVERY, SLOWEST, PictureRate


def run(rate: PictureRate, bytes_a_picture: int, pictures: int) -> None:
    at, sent = 100.0, 0
    for _ in range(pictures):
        rate.take(at, sent)
        at += rate.every
        sent += bytes_a_picture


def test_above_the_limit_the_rate_halves_until_it_holds() -> None:
    rate = PictureRate(60_000.0)
    run(rate, 29_000, 9)
    assert (rate.every, rate.text) == (EVERY, "2 fps")
    rate.restart()
    run(rate, 55_000, 9)
    assert (rate.every, rate.text) == (1.0, "1 fps (limit 60 kB/s)")
    rate.restart()
    run(rate, 10_000_000, 20)
    assert rate.every == SLOWEST


def test_it_doubles_again_once_that_fits() -> None:
    rate = PictureRate(60_000.0)
    run(rate, 55_000, 4)
    assert rate.every == 1.0
    rate.take(200.0, 10_000)
    rate.take(201.0, 20_000)
    assert rate.every == EVERY


@pytest.mark.parametrize(("later", "due"), [(0.3, False), (0.45, True)])
def test_a_picture_may_come_a_little_early(later: float, due: bool) -> None:
    rate = PictureRate(1.0)
    assert rate.is_due(5.0)
    rate.take(5.0, 0)
    assert rate.is_due(5.0 + later) is due
