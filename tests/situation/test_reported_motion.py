"""What vehicles say they do comes before any guess from their poses: written by the standard's text."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.cli.status.report import attention, report
from fleet_tui.model.geometry import Pose
from fleet_tui.model.history.facts import Activity
from fleet_tui.situation.activity import activities
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.tables.doing import told_text
from tests.support.vda_fleet import AGV, VehicleSite
from tests.support.vda_hall import hall_graph
from tests.support.vda_messages import node, position, state

DRIVEN: dict[str, Any] = {"orderId": "o", "nodeStates": [node("n1", 2)], "lastNodeId": "n0"}
LINE_GUIDED: dict[str, Any] = {**DRIVEN, "agvPosition": None}
PICK = [{"actionId": "o-pick", "actionType": "pick", "actionStatus": "RUNNING"}]


def site(folder: Path) -> VehicleSite:
    found = VehicleSite()
    found.apply(hall_graph(folder))
    return found


def does(vehicle: VehicleSite) -> Activity | None:
    return activities(vehicle.state, [vehicle.agv]).get(AGV)


def for_seconds(vehicle: VehicleSite, seconds: int, every: int = 30, **fields: Any) -> None:
    """It says the same as often as the standard wants it."""
    for second in range(seconds):
        if second % every == 0:
            stamp = datetime.fromtimestamp(vehicle.now, UTC).isoformat(timespec="milliseconds")
            vehicle.read("state", state(**fields, timestamp=stamp))
        vehicle.wait(1)


@pytest.mark.parametrize(
    "said",
    [
        {"driving": True},
        {"driving": None, "velocity": {"vx": 0.4, "vy": 0.0}},
        {"driving": False, "velocity": {"vx": 0.0, "vy": -0.4}},
    ],
)
def test_a_line_guided_vehicle_drives_while_it_says_so(tmp_path: Path, said: dict[str, Any]) -> None:
    vehicle = site(tmp_path)
    for_seconds(vehicle, 180, **LINE_GUIDED, **said)
    assert does(vehicle) is Activity.DRIVING and told_text(vehicle.state, vehicle.agv) == "driving"
    assert attention(vehicle.state) == []
    (reason,) = reasons(vehicle.state, vehicle.agv)
    assert (reason.name, reason.evidence) == ("agv is driving", "reported by the vehicle")


def test_one_without_a_graph_too(tmp_path: Path) -> None:
    vehicle = VehicleSite()
    for_seconds(vehicle, 65, **LINE_GUIDED, driving=True)
    assert vehicle.agv.pose is None and does(vehicle) is Activity.DRIVING


def test_a_vehicle_that_stands_with_an_order_is_not_driving_for_the_time_of_its_first_states() -> None:
    vehicle = VehicleSite()
    for second in range(28):
        if second % 14 == 0:
            vehicle.read("state", state(**DRIVEN, driving=False))
        vehicle.wait(1)
        assert does(vehicle) is Activity.WAITING, second
        assert not any("driving" in one.name for one in reasons(vehicle.state, vehicle.agv))


def test_a_running_action_is_named_with_its_time_and_nothing_is_blocked(tmp_path: Path) -> None:
    vehicle = site(tmp_path)
    vehicle.read("state", state(**DRIVEN, driving=True))
    for_seconds(vehicle, 420, **DRIVEN, driving=False, actionStates=PICK)
    assert told_text(vehicle.state, vehicle.agv) == "pick, 7 min" and does(vehicle) is Activity.LOADING
    first = reasons(vehicle.state, vehicle.agv)[0]
    assert (first.name, first.remedy) == ("pick, 7 min", "")
    assert attention(vehicle.state) == [] and vehicle.alarms == {}
    found = report(vehicle.state)["robots"][0]
    assert (found["action"], found["action_s"]) == ("pick", 420.0)
    vehicle.read(
        "state", state(**DRIVEN, driving=False, actionStates=[{**PICK[0], "actionStatus": "FINISHED"}])
    )
    assert told_text(vehicle.state, vehicle.agv).startswith("waiting")


def test_actions_beside_an_order_are_no_work() -> None:
    vehicle = VehicleSite()
    instant = [{"actionId": "c", "actionType": "cancelOrder", "actionStatus": "RUNNING"}]
    vehicle.read("state", state(**DRIVEN, driving=False, actionStates=instant))
    assert does(vehicle) is Activity.WAITING and report(vehicle.state)["robots"][0]["action"] is None


def test_a_pose_that_does_not_change_is_still_told_of_a_vehicle_that_says_it_drives() -> None:
    vehicle = VehicleSite()
    for_seconds(vehicle, 120, every=1, **DRIVEN, driving=True)
    assert "stuck" in vehicle.alarms


def test_charging_that_is_reported_comes_before_a_guess_from_the_first_poses() -> None:
    vehicle = VehicleSite()
    vehicle.wait(20)
    vehicle.read("state", state(driving=None, batteryState={"batteryCharge": 30, "charging": True}))
    assert does(vehicle) is Activity.CHARGING


def test_a_place_between_nodes_is_estimated_and_says_so(tmp_path: Path) -> None:
    vehicle = site(tmp_path)
    vehicle.read("state", state(**LINE_GUIDED, driving=True, distanceSinceLastNode=0.5))
    assert vehicle.agv.pose is not None and vehicle.agv.pose.value == Pose(0.5, 0.0, 0.0)
    assert report(vehicle.state)["robots"][0]["pose"]["estimated"] is True
    vehicle.wait(1)
    left = [node("n2", 4)]
    vehicle.read(
        "state", state(**{**LINE_GUIDED, "nodeStates": left, "lastNodeId": "n1"}, distanceSinceLastNode=9)
    )
    assert vehicle.agv.pose.value == Pose(4.0, 0.0, 0.0) and vehicle.agv.jumps == ()


def test_a_position_of_its_own_is_never_replaced_by_an_estimate(tmp_path: Path) -> None:
    vehicle = site(tmp_path)
    vehicle.read("visualization", state(agvPosition=position(7.0, 1.0)))
    vehicle.read("state", state(**LINE_GUIDED))
    assert vehicle.agv.pose is not None and vehicle.agv.pose.value.x == 7.0
    assert "estimated" not in report(vehicle.state)["robots"][0]["pose"]


def test_how_long_an_action_runs_that_began_before_the_console_is_what_was_seen() -> None:
    vehicle = VehicleSite()
    for_seconds(vehicle, 31, **DRIVEN, driving=False, actionStates=PICK)
    assert told_text(vehicle.state, vehicle.agv) == "pick, 31 s (seen)"


def test_a_paused_vehicle_that_says_it_drives_is_stopping_and_not_paused() -> None:
    vehicle = VehicleSite()
    for_seconds(vehicle, 2, every=1, **DRIVEN, driving=True)
    vehicle.read("state", state(**DRIVEN, driving=True, paused=True))
    vehicle.wait(0.1)
    assert told_text(vehicle.state, vehicle.agv) == "stopping" and does(vehicle) is Activity.DRIVING
    assert report(vehicle.state)["robots"][0]["paused"] is False
    for_seconds(vehicle, 6, every=1, **DRIVEN, driving=True, paused=True)
    assert told_text(vehicle.state, vehicle.agv).startswith("still moving") and "pause" in vehicle.alarms
    vehicle.read("state", state(**DRIVEN, driving=False, paused=True))
    vehicle.wait(0.1)
    assert told_text(vehicle.state, vehicle.agv).startswith("paused") and does(vehicle) is Activity.PAUSED
