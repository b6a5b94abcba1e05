"""Commands that failed: an alarm in the robot's words, one for each robot or for a request for many."""

import pytest

from fleet_tui.model import events
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.commands import CancelOrder, PauseRobot, Stage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.failures import DRIVES_ON, MAY_FOLLOW
from fleet_tui.text.language import Message
from tests.support.alarms import alarm, alarms, up
from tests.support.fleets import LINK, R0, T0, WALL, battery, graph, labels, place_order, queue, reduced, tick


def ended(id_: int, at: float, *stages: Stage, detail: str = "") -> list[events.Event]:
    return [
        events.CommandAdvanced(id_, Stage.SENT, at),
        *(events.CommandAdvanced(id_, stage, at, Message(detail)) for stage in stages),
    ]


def failed(state: FleetState, id_: int, at: float, *stages: Stage, detail: str = "queue full") -> FleetState:
    issued = events.CommandIssued(id_, place_order(R0, 1, 2), at, WALL)
    ends = ended(id_, at, *(stages or (Stage.REFUSED,)), detail=detail)
    return reduced(state, battery(at), tick(at), issued, *ends, tick(at))


def test_a_refused_command_is_an_alarm_in_the_robots_words() -> None:
    state = reduced(up(), graph(1, 2), labels({1: "Base", 2: "Store"}))
    state = failed(state, 7, T0)
    assert alarm(state, "command").text == "refused: queue full (order Base -> Store)"
    assert alarm(state, "command").condition.priority.name == "MEDIUM"


def test_not_confirmed_is_an_alarm_that_returns_after_a_while_and_stays_until_it_is_seen() -> None:
    state = failed(up(), 7, T0, Stage.ACCEPTED, detail="")
    assert alarms(state) == {}
    state = reduced(state, battery(T0 + 6), tick(T0 + 6))
    text = "not confirmed: accepted; no queue received since (order 1 -> 2)"
    assert alarm(state, "command").text == text
    assert alarm(reduced(state, battery(T0 + 35), tick(T0 + 35)), "command").text == text
    state = reduced(state, battery(T0 + 40), tick(T0 + 40))
    assert (alarm(state, "command").stage, alarm(state, "command").text) == (
        AlarmStage.RETURNED,
        "was not confirmed: order 1 -> 2",
    )
    assert alarm(state, "command").condition.remedy == MAY_FOLLOW
    assert alarms(reduced(state, desk_events.AlarmAcknowledged())) == {}


def test_further_failures_of_a_robot_count_and_need_another_look() -> None:
    state = reduced(failed(failed(up(), 7, T0), 8, T0 + 1), desk_events.AlarmAcknowledged())
    assert (alarm(state, "command").count, state.unacknowledged) == (2, 0)
    state = failed(state, 9, T0 + 2)
    assert (alarm(state, "command").count, state.unacknowledged) == (3, 1)
    assert alarm(state, "command").shown_wall == state.wall, "of the newest command, whose text it has"
    assert len(state.alarms) == 1


@pytest.mark.parametrize("stage", [Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN, Stage.NOT_SENT])
def test_what_is_not_over_or_never_left_is_no_alarm(stage: Stage) -> None:
    assert alarms(failed(up(), 7, T0, stage)) == {}


def test_a_pause_that_failed_is_urgent_and_for_many_robots_one_alarm() -> None:
    state = up(100)
    state = reduced(
        state, *(events.CommandIssued(n, PauseRobot(f"robot_{n}"), T0 + n / 1000, WALL) for n in range(100))
    )
    for n in range(100):
        state = reduced(state, *ended(n, T0, Stage.REFUSED), *[tick(T0 + n / 100)] * (n % 20 == 0))
    state = reduced(state, tick(T0 + 1))
    assert [one.key for one in state.alarms] == [(LINK, "many commands")]
    assert state.alarms[0].text == "refused: pause of 100 robots"
    assert (state.alarms[0].condition.priority.name, state.alarms[0].count) == ("HIGH", 100)


def test_the_only_one_of_many_that_failed_is_named() -> None:
    given = (events.CommandIssued(n, PauseRobot(f"robot_{n}"), T0 + n / 1000, WALL) for n in range(9))
    state = reduced(up(9), *given, *ended(4, T0, Stage.REFUSED), tick(T0 + 1))
    assert [one.text for one in state.alarms] == ["robot_4 refused: pause"]


def test_a_refused_cancellation_of_an_order_that_goes_on_asks_to_stop_the_robot() -> None:
    for order, remedy in (((1, 1, 2, "W"), DRIVES_ON), (None, "")):
        state = reduced(up(), battery(T0), queue(T0, *([order] if order else []), current=1))
        issued = events.CommandIssued(7, CancelOrder(R0, "1"), T0, WALL)
        state = reduced(state, issued, *ended(7, T0, Stage.REFUSED, detail="rejected"), tick(T0))
        assert alarm(state, "command").condition.remedy == remedy
