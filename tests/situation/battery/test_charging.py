"""A robot at a charger: its low battery is no trouble, until charging does not help."""

from msgspec.structs import replace

from fleet_tui.keys.keymap import keymap
from fleet_tui.model.events import Event, FloorGraphLoaded, GraphReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import MemberReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Role, RouteGraph, Vertex
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.order import OrderState
from fleet_tui.situation.activity import activity
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.alarms.conditions import CHARGES_WITHIN
from fleet_tui.situation.alarms.trouble import in_turn, urgency
from fleet_tui.situation.battery.charging import AT_CHARGER, charger_of, has_low_battery
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.lines.why import why_lines
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.fleet import fleet_table
from tests.support.fleets import F0, R0, T0, battery, fleet, link_up, pose, queue, reduced, text_of, tick
from tests.support.rmf import reported, rmf_fleet
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import position, state

CHARGER = Vertex("1", 0.0, 0.0, Role.DOCKING)
GRAPH = GraphReceived(R0, F0, RouteGraph({"1": CHARGER, "2": Vertex("2", 5.0, 0.0)}))


def standing(x: float, *facts: Event, seconds: float = 10.0) -> FleetState:
    """A robot with a low battery and no order that has stood in one place for some time."""
    end = T0 + seconds
    first = (link_up(T0), GRAPH, pose(T0, x), queue(T0))
    return reduced(fleet(), *first, pose(end, x), queue(end), battery(end, 12.0), *facts, tick(end))


def at(state: FleetState) -> Vertex | None:
    return charger_of(state, state.robots[R0])


def test_a_robot_is_at_a_charger_by_a_pose_that_holds_and_without_an_order() -> None:
    assert at(standing(AT_CHARGER)) == CHARGER
    assert at(standing(AT_CHARGER + 0.1)) is None and at(standing(5.0)) is None
    assert at(standing(0.0, queue(T0 + 10, (7, 1, 2, "W"), current=7))) is None
    docked = standing(0.0)
    assert at(replace(docked, now=docked.now + 60)) is None


def test_a_low_battery_is_no_alarm_at_a_charger_and_one_beside_it() -> None:
    assert not standing(0.0).alarms
    assert [alarm.text for alarm in standing(5.0).alarms] == ["battery 12 %"]


def test_a_battery_still_low_after_long_charging_is_an_alarm() -> None:
    (alarm,) = standing(0.0, seconds=CHARGES_WITHIN + 60).alarms
    assert alarm.text == "battery 12 % after 31 min at the charger"
    assert action_of(alarm.condition) == "Check the robot and its charger"


def test_a_robot_on_its_way_to_a_charger_needs_no_order() -> None:
    ordered, elsewhere = (
        standing(5.0, queue(T0 + 10, (7, *way, "W"), current=7)) for way in ((2, 1), (1, 2))
    )
    (alarm,), (other,) = ordered.alarms, elsewhere.alarms
    assert action_of(alarm.condition) == "Wait: it is on its way to a charger"
    assert action_of(other.condition) == "Send it to a charger"
    told, beside = (
        next(one for one in reasons(state, state.robots[R0]) if one.name == "battery 12 %")
        for state in (ordered, elsewhere)
    )
    assert (told.remedy, told.keys) == ("Wait: it is on its way to a charger", ())
    assert beside.keys == ("charge",)


def test_who_drives_to_a_charger_is_offered_no_other_order() -> None:
    end = T0 + 10
    way = queue(end, (7, 2, 1, "W"), current=7)
    state = reduced(standing(5.0, way), pose(end + 0.5, 4.5), tick(end + 0.6))
    lines = why_lines(state, state.robots[R0], keymap({})[0])
    assert lines[0].startswith("robot_0 is driving")
    assert lines[-1].strip() == "Wait: it is on its way to a charger"


def test_the_row_of_a_charging_robot_is_calm() -> None:
    calm, troubled = (fleet_table(standing(x), R0, 60).rows[0].runs for x in (0.0, 5.0))
    assert "charging" in text_of(calm) and StyleRole.ALARM not in {role for _, role in calm}
    assert "idle" in text_of(troubled) and (" 12 % ", StyleRole.WARN) in troubled


def test_a_battery_is_low_below_the_limit_of_its_alarm() -> None:
    state = standing(4.0)
    assert has_low_battery(state, state.robots[R0])
    full = reduced(state, battery(T0 + 11, 20.0))
    assert not has_low_battery(full, full.robots[R0])


def test_who_is_on_its_way_to_a_charger_comes_after_those_that_need_somebody() -> None:
    state = reduced(
        fleet(2),
        *(link_up(T0), GRAPH, pose(T0), pose(T0, robot="robot_1"), queue(T0, (7, 2, 1, "W"), current=7)),
        *(battery(T0, 5.0), battery(T0, 15.0, robot="robot_1"), tick(T0)),
    )
    assert [one.condition.source for one in sorted(state.alarms, key=urgency)] == ["robot_1", R0]
    assert in_turn(state) == ["robot_1", R0], "though its battery is the emptier"


def test_a_robot_whose_driver_says_that_it_charges_does_so_whatever_orders_it_has() -> None:
    says = [
        MemberReported(R0, T0 + after, Pose(0.0, 0.0), F0, after, 6.0, "charging", "")
        for after in (0.0, 30.0)
    ]
    state = reduced(rmf_fleet(), link_up(T0), says[0], reported(T0, "a", OrderState.IN_PROCESS), says[1])
    state = reduced(state, tick(T0 + 30))
    robot = state.robots[R0]
    assert activity(state, robot) is Activity.CHARGING
    assert "charging" in [one.name for one in reasons(state, robot)]
    assert not _of(state), "it may charge for a while"
    told = next(one for one in reasons(state, robot) if one.name == "charging")
    assert (told.remedy, told.keys) == ("Wait: it is charging", ())
    moving = MemberReported(R0, T0 + 31, Pose(3.0, 0.0), F0, 31.0, 6.0, "moving", "")
    left = reduced(state, moving, tick(T0 + 32))
    assert _of(left) == ["Send it to a charger"]


def _of(state: FleetState) -> list[str]:
    return [action_of(one.condition) for one in state.alarms if one.condition.source == R0]


def test_a_vehicle_at_a_charger_that_says_that_it_does_not_charge_is_idle_and_needs_somebody() -> None:
    def vehicle_at_charger(charging: bool | None) -> VehicleSite:
        site = VehicleSite()
        site.apply(FloorGraphLoaded("hall", RouteGraph({"1": CHARGER})))
        for _ in range(10):
            site.read("state", state(agvPosition=position(0.0, 0.0), batteryState=power(charging)))
            site.wait(1)
        return site

    def power(charging: bool | None) -> dict[str, object]:
        return {"batteryCharge": 12.0, "charging": charging}

    idle = vehicle_at_charger(False)
    assert activity(idle.state, idle.agv) is Activity.IDLE
    (alarm,) = (one for one in idle.state.alarms if one.condition.kind == "battery")
    assert action_of(alarm.condition) == "Check the robot and its charger"
    for said in (True, None):
        found = vehicle_at_charger(said)
        assert activity(found.state, found.agv) is Activity.CHARGING and "battery" not in found.alarms
