"""Any sequence of facts: nothing raises, no robot is lost, no command ends twice."""

from itertools import pairwise
from typing import get_args

from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import fields

from fleet_tui.model import events
from fleet_tui.model.commands import NEXT, CommandRecord, Stage
from fleet_tui.model.fleet import FleetState
from tests.support.any_events import ANY, FACTS
from tests.support.fleets import LINK, fleet, reduced


def test_every_kind_of_fact_is_tried() -> None:
    flat: set[type] = set()
    for kind in get_args(events.Event):
        flat |= set(get_args(kind)) or {kind}
    assert flat == set(FACTS)


def check(state: FleetState) -> None:
    assert list(state.robots) == ["robot_0", "robot_1"]
    assert [robot.number for robot in state.robots.values()] == [1, 2]
    assert list(state.links) == [LINK]
    assert set(state.floors) == {"floor_0", "floor_1"}
    keys = [alarm.key for alarm in state.alarms]
    assert len(keys) == len(set(keys))
    for robot in state.robots.values():
        assert state.is_paused(robot) in (True, False) and state.is_online(robot) in (True, False)
        assert robot.floor in (None, "floor_0", "floor_1")
        assert robot.faults >= 0 and bool(robot.last_fault) <= bool(robot.faults)


@given(ANY)
def test_nothing_raises_and_no_robot_is_ever_lost(facts: list[events.Event]) -> None:
    check(reduced(fleet(2, 2), *facts))


@given(ANY)
def test_facts_change_no_value_that_somebody_holds(facts: list[events.Event]) -> None:
    """The screen reads a state while the writer makes the next one."""
    state = fleet(2, 2)
    before = [(name.name, repr(getattr(state, name.name))) for name in fields(state)]
    reduced(state, *facts)
    assert [(name.name, repr(getattr(state, name.name))) for name in fields(state)] == before


@given(st.lists(FACTS[events.CommandAdvanced] | FACTS[events.TimePassed] | FACTS[events.CommandIssued]))
def test_a_command_goes_only_along_the_table(facts: list[events.Event]) -> None:
    ended: dict[int, CommandRecord] = {}
    state = fleet()
    for fact in facts:
        state = reduced(state, fact)
        for record in state.commands:
            stages = [step.stage for step in record.steps]
            assert stages[0] is Stage.CHECKED
            assert all(later in NEXT[earlier] for earlier, later in pairwise(stages))
            assert ended.get(record.id, record) == record
            if record.is_decided:
                ended[record.id] = record
