"""The news of a robot: each as urgent as it is, and whole or as a sign."""

import pytest
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.news import in_cells, listed, news, shortened_news
from fleet_tui.ui.view.tables.table import Run
from tests.support.fleets import LINK, R0, T0, battery, commanded, fleet, link_up, pose, queue, reduced, tick

BLOCKED = events.ObstacleReported(R0, T0 + 1, 31.0)


def received(*facts: events.Event) -> FleetState:
    """A robot that just spoke, and these facts."""
    return reduced(fleet(), link_up(T0), pose(T0 + 1), battery(T0 + 1), queue(T0 + 1), *facts, tick(T0 + 1))


def found(state: FleetState) -> list[Run]:
    return list(news(state, state.robots[R0]))


def test_a_calm_robot_has_none() -> None:
    assert found(received()) == []


def test_trouble_is_less_loud_while_its_alarm_is_shelved() -> None:
    state = received(BLOCKED)
    assert found(state) == [("obstacle 31 s", StyleRole.ALARM)]
    shelved = reduced(state, desk_events.AlarmShelved(R0, "obstacle", T0 + 600), tick(T0 + 1))
    assert found(shelved) == [("obstacle 31 s", StyleRole.WARN)]


def test_a_robot_that_was_never_seen_is_not_called_paused() -> None:
    given = commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED)
    unseen = found(reduced(fleet(), link_up(T0), *given, tick(T0 + 1)))
    assert [text for text, _ in unseen] == ["never seen"]
    assert "paused (by us)" in [text for text, _ in found(received(*given))]


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        (40, "obstacle 31 s, paused (elsewhere)"),
        (21, "obstacle 31 s, paused"),
        (15, "obstacle 31 s, ‖"),
        (4, "obstacle 31 s, ‖"),
    ],
)
def test_a_pause_gives_way_to_what_is_more_urgent(cells: int, said: str) -> None:
    state = received(BLOCKED, events.PausedReported(R0, T0 + 1, True))
    assert "".join(text for text, _ in listed(shortened_news(found(state), cells))) == said


def test_the_cause_of_a_failure_stays_and_its_order_goes() -> None:
    for text, said in (
        ("refused: no path (order A -> B)", "refused: no path"),
        ("failed: no progress (error 105) (order A -> B)", "failed: no progress (error 105)"),
        ("lost: order A -> B (order 4: before it started)", "lost: order"),
        ("refused: order A -> B", "refused: order"),
    ):
        assert shortened_news([(text, StyleRole.ALARM)], 3) == [(said, StyleRole.ALARM)]


def test_a_pause_alone_stays_a_word() -> None:
    assert shortened_news([("paused (elsewhere)", StyleRole.WARN)], 3)[0][0] == "paused"


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        (40, "refused: no path, pose 25 s old, idle"),
        (36, "refused: no path, pose 25 s old…"),
        (32, "refused: no path, pose 25 s old…"),
        (31, "refused: no path…"),
        (16, "refused…"),
        (8, "refused…"),
    ],
)
def test_a_list_without_space_ends_with_a_whole_text(cells: int, said: str) -> None:
    """Half a word, such as "po…", tells nothing."""
    texts = [(text, StyleRole.TEXT) for text in ("refused: no path", "pose 25 s old", "idle")]
    assert "".join(text for text, _ in in_cells(texts, cells)) == said


def test_a_robot_behind_a_late_bridge_is_silent_and_not_offline() -> None:
    state = reduced(received(), tick(T0 + 60))
    assert ("offline 59 s", StyleRole.ALARM) in found(state)
    link = replace(state.links[LINK], late=9.0)
    told = found(replace(state, links={LINK: link}, alarms=()))
    assert told == [("offline 59 s", StyleRole.ALARM)], "for longer than its bridge is late"
    newer = replace(state.robots[R0], last_received=T0 + 50, pose=None)
    late = replace(state, links={LINK: link}, alarms=(), robots={R0: newer})
    assert found(late) == [("silent 10 s", StyleRole.WARN)]
    late = replace(state, links={LINK: link}, robots={R0: newer})
    assert ("silent 10 s", StyleRole.ALARM) in found(late), "it has an alarm"
    newer = replace(state.robots[R0], last_received=T0 + 50)
    assert found(replace(state, links={LINK: link}, alarms=(), robots={R0: newer})) == [
        ("pose 59 s old", StyleRole.WARN)
    ]
