"""A held panning key moves further and further, up to a limit."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.ui.controllers.map import Stride


def held(presses: int, every: float) -> list[int]:
    stride, found = Stride(), []
    for n in range(presses):
        stride = stride.then((1, 0), 100.0 + n * every)
        found.append(stride.times)
    return found


def test_a_key_that_repeats_gets_faster_and_single_presses_do_not() -> None:
    repeated = held(40, 0.033)
    assert repeated[0] == 1
    assert repeated == sorted(repeated)
    assert repeated[-1] == 4
    assert set(held(10, 0.3)) == {1}


def test_turning_round_starts_anew() -> None:
    stride = Stride()
    for n in range(20):
        stride = stride.then((1, 0), n * 0.03)
    assert stride.then((-1, 0), 0.6).times == 1
    assert stride.then((1, 0), 0.6).times > 1


@given(st.lists(st.tuples(st.sampled_from([(1, 0), (0, 1)]), st.floats(0.0, 2.0)), max_size=30))
def test_a_step_is_never_longer_than_four(presses: list[tuple[tuple[int, int], float]]) -> None:
    stride, now = Stride(), 0.0
    for way, pause in presses:
        now += pause
        stride = stride.then(way, now)
        assert 1 <= stride.times <= 4
