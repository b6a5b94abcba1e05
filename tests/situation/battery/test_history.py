"""Battery levels as they were seen: bounded, with gaps where nothing was seen."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.battery.history import (
    EVERY,
    KEPT,
    KEPT_FOR,
    UNSEEN,
    BatteryHistories,
    BatteryHistory,
    runs_of,
)
from tests.support.fleets import R0, T0, battery, fleet, link_up, pose, reduced, tick


def seen(*levels: tuple[float, float | None]) -> BatteryHistory:
    history = BatteryHistory()
    for at, percent in levels:
        history.look(at, percent)
    return history


def test_a_level_is_kept_once_a_minute_and_when_it_changes_by_a_per_cent() -> None:
    history = seen(*((float(at), 80.0) for at in range(121)), (121.0, 79.5), (122.0, 79.0))
    assert [(one.at, one.percent) for one in history.samples] == [
        (0.0, 80.0),
        (60.0, 80.0),
        (120.0, 80.0),
        (122.0, 79.0),
    ]


def test_the_newest_level_ends_the_curve_while_it_is_seen() -> None:
    assert [(one.at, one.percent) for one in seen((0.0, 80.0), (30.0, 79.5)).levels][1:] == [(30.0, 79.5)]
    assert seen((0.0, 80.0), (30.0, 79.5), (90.0, None)).levels[-1].at == 30.0
    assert seen().levels == ()


def test_what_was_not_seen_is_a_gap() -> None:
    lost = seen((0.0, 80.0), (1.0, None), (2.0, 80.0), (3.0, 78.0))
    late = seen((0.0, 80.0), (50.0, 79.5), (51.0, None), (52.0, 79.5))
    assert [[one.at for one in run] for run in runs_of(late.levels)] == [[0.0, 50.0], [52.0]]
    suspended = seen((0.0, 80.0), (UNSEEN + 1.0, 80.0))
    short = seen((0.0, 80.0), (UNSEEN, 80.0))
    assert [[one.at for one in run] for run in runs_of(tuple(lost.samples))] == [[0.0], [2.0, 3.0]]
    assert [len(runs_of(tuple(one.samples))) for one in (suspended, short)] == [2, 1]


def test_a_recording_that_goes_back_shows_nothing_of_later() -> None:
    history = seen(*((60.0 * minute, 80.0 - minute) for minute in range(10)), (200.0, 77.0), (201.0, 75.0))
    assert [one.at for one in history.samples] == [0.0, 60.0, 120.0, 180.0, 201.0]
    assert len(runs_of(tuple(history.samples))) == 1
    assert [one.at for one in seen((100.0, 80.0), (50.0, 81.0)).samples] == [50.0]


@given(st.lists(st.tuples(st.floats(0, 1e6), st.none() | st.floats(-1e3, 1e3)), max_size=60))
def test_samples_are_in_the_order_of_time_and_of_a_day(levels: list[tuple[float, float | None]]) -> None:
    history = seen(*levels)
    times = [one.at for one in history.samples]
    assert times == sorted(times)
    assert not times or times[-1] - times[0] <= KEPT_FOR
    assert sum(map(len, runs_of(tuple(history.samples)))) == len(times)


def test_a_level_that_jumps_all_the_time_fills_no_memory() -> None:
    history = seen(*((float(at), 100.0 * (at % 2)) for at in range(KEPT + 100)))
    assert len(history.samples) == KEPT and history.samples[-1].at == KEPT + 99


def level(at: float, percent: float) -> FleetState:
    return reduced(fleet(), link_up(T0), pose(at), battery(at, percent), tick(at))


def test_the_levels_of_a_state_are_taken_while_they_are_fresh() -> None:
    histories = BatteryHistories()
    histories.look(level(T0, 80.0))
    histories.look(level(T0 + 0.1, 60.0))
    assert [one.percent for one in histories.of(R0)] == [80.0], "once a second"
    histories.look(reduced(level(T0, 80.0), tick(T0 + EVERY)))
    histories.look(level(T0 + EVERY + 2, 70.0))
    assert [(one.percent, one.follows) for one in histories.of(R0)] == [(80.0, False), (70.0, False)]
    assert histories.of("robot_9") == ()
