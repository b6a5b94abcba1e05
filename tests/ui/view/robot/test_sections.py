"""The sections of a robot's page: nothing old looks new, and nothing from outside is raw."""

from msgspec.structs import replace

from fleet_tui.model.audit_record import PastAlarm
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import Event, ObstacleReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.robot.sections import (
    PageSection,
    alarms_section,
    commands_section,
    orders_section,
    route_section,
    state_section,
)
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import width_of
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    pose,
    queue,
    reduced,
    text_of,
    tick,
)

NAMED = (graph(1, 2, 3), labels({1: "Base", 2: "Store", 3: "Do\x1bck"}))


def received(*facts: Event, at: float = T0 + 0.5) -> FleetState:
    return reduced(fleet(), link_up(T0), *NAMED, pose(T0), battery(T0), *facts, tick(at))


def text(section: PageSection) -> str:
    lines = section.drawn(60)
    assert all(width_of(line) == 60 for line in lines)
    return "\n".join(text_of(line).rstrip() for line in lines)


def clock(_wall: float) -> str:
    return "12:00:00"


def alarms(state: FleetState, *past: PastAlarm, note: Message = EMPTY) -> str:
    return text(alarms_section(state, state.robots[R0], past, clock, note))


def test_the_state_is_told_even_of_a_calm_robot() -> None:
    calm, gone = received(), received(at=T0 + 60)
    assert "State     no queue yet\n" in text(state_section(calm, calm.robots[R0]))
    idle = received(queue(T0))
    assert "State     idle\n" in text(state_section(idle, idle.robots[R0]))
    low = received(queue(T0), battery(T0 + 0.1, 5.0))
    assert "State     idle, battery 5 %" in text(state_section(low, low.robots[R0]))
    held = received(ObstacleReported(R0, T0 + 0.4, 54.0), at=T0 + 0.4)
    assert text(state_section(held, held.robots[R0])).count("obstacle 54 s") == 1
    said = Complaint(Message("drive: ERROR no odometry, wheels slip on a wet floor"), "diagnostics", True, T0)
    told = text(state_section(calm, calm.robots[R0], [said]))
    assert "Reports   drive: ERROR no odometry, wheels\n          slip on a wet floor\n" in told
    shown = state_section(gone, gone.robots[R0])
    assert "offline 60 s" in text(shown)
    (level,) = [line for line in shown.lines if text_of(line).startswith("Battery")]
    assert ("60 s ago ", StyleRole.WARN) in [(f"{part.strip()} ", role) for part, role in level]


def test_the_route_has_the_stops_and_the_metres_that_are_left() -> None:
    driving = received(queue(T0, (4, 2, 3, "W"), current=4))
    shown = text(route_section(driving, driving.robots[R0]))
    assert "Order     Store -> Do␛ck" in shown and "Left      2 m on the graph" in shown
    old = reduced(driving, battery(T0 + 30), tick(T0 + 30))
    assert "2 m from its pose 30 s ago" in text(route_section(old, old.robots[R0]))
    idle = received()
    assert "no order in process" in text(route_section(idle, idle.robots[R0]))


def test_orders_that_wait_are_listed_up_to_a_few_and_an_old_queue_is_marked() -> None:
    orders = [(n, 1, 2, "W") for n in range(1, 9)]
    many = received(queue(T0, *orders))
    shown = text(orders_section(many, many.robots[R0]))
    assert shown.count("Waiting") == 5 and "and 3 more" in shown and "old" not in shown
    old = reduced(many, battery(T0 + 30), tick(T0 + 30))
    assert "Queue     30 s old" in text(orders_section(old, old.robots[R0]))
    ended = reduced(many, queue(T0 + 1, *orders[1:]), tick(T0 + 2))
    assert "Ended     Base -> Store" in text(orders_section(ended, ended.robots[R0]))


def test_alarms_are_those_that_hold_then_those_that_are_over() -> None:
    low = received(battery(T0 + 0.1, 5.0))
    over = PastAlarm("offline", Message("offline"), "11:00:00", "11:01:00")
    shown = alarms(low, over).splitlines()
    assert shown[1] == "▲ new  battery 5 % since 12:00:00" and "charger" in shown[2]
    assert shown[3] == "  over 11:00:00 to 11:01:00  off␛line"
    assert "none in this session" in alarms(received())
    assert "not in a recording" in alarms(received(), note=Message("not in a recording"))


def test_an_alarm_that_waits_for_an_acknowledgement_is_listed_once() -> None:
    low = received(battery(T0 + 0.1, 5.0))
    latched = replace(low, limits=replace(low.limits, latched=None))
    over = reduced(latched, battery(T0 + 1, 80.0), tick(T0 + 1), tick(T0 + 9), battery(T0 + 9), pose(T0 + 9))
    past = [PastAlarm("battery", Message("battery {n} %", n=n), "11:00:00", "11:01:00") for n in (5, 7)]
    shown = alarms(over, *past)
    assert "▽ over" in shown and "battery 5 %" not in shown and "battery 7 %" in shown


def test_commands_are_told_with_their_outcome() -> None:
    sent = received(*commanded(1, PauseRobot(R0), Stage.SENT, Stage.ACCEPTED, at=T0))
    assert "pause: accepted" in text(commands_section(sent, sent.robots[R0], clock))
    assert "none from this console" in text(commands_section(received(), received().robots[R0], clock))
