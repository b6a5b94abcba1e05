"""Errors and warnings that a robot reports about itself, as reasons."""

from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.ros_logs import Health, LogLine, PartDiagnosis
from fleet_tui.situation.why.complaints import complaints
from fleet_tui.situation.why.reason import Strength
from fleet_tui.situation.why.why import reasons
from tests.support.fleets import LINK, R0
from tests.support.planted_fleet import Planted
from tests.support.situations import driving

ERROR, WARN, OK = Health.ERROR, Health.WARN, Health.OK


def counter_of(*diagnoses: PartDiagnosis, log: tuple[LogLine, ...] = ()) -> LinkCounter:
    counter = LinkCounter(LINK, ())
    counter.take_health(diagnoses)
    for line in log:
        counter.take_log(line)
    return counter


def texts(counter: LinkCounter | None, robots: int = 2, after: float = 0.0) -> list[str]:
    planted = Planted(robots=robots).run(after)
    return [one.text for one in complaints(planted.state, planted.robot, counter)]


def now() -> float:
    return Planted().now


def test_only_what_it_reports_about_itself_counts_and_errors_are_first() -> None:
    at = now()
    counter = counter_of(
        PartDiagnosis(at, "robot_0: laser", WARN, "something is close"),
        PartDiagnosis(at, "robot_0: battery", OK, "charged"),
        PartDiagnosis(at, "robot_00: drive", ERROR, "another one"),
        PartDiagnosis(at, "robot_1: drive", ERROR, "another one"),
        PartDiagnosis(at, "motors", ERROR, "hot", hardware="robot_0"),
        log=(LogLine(at, 30, "/robot_1/drive", "slips"), LogLine(at, 20, "/robot_0/drive", "ready")),
    )
    assert texts(counter) == ["motors: ERROR hot", "laser: WARN something is close"]
    assert texts(None) == []


def test_all_of_a_link_is_about_its_only_robot() -> None:
    counter = counter_of(PartDiagnosis(now(), "base driver", ERROR, "no odometry"))
    assert texts(counter, robots=1) == ["base driver: ERROR no odometry"]
    assert texts(counter) == []


def test_lines_of_one_cause_count_once_and_those_of_the_bridge_are_no_robots() -> None:
    at = now()
    counter = counter_of(
        log=(
            LogLine(at, 40, "controller_server", "Failed to make progress"),
            LogLine(at, 30, "controller_server", "[follow_path] [ActionServer] Aborting handle."),
            LogLine(at, 40, "bt_navigator", "Goal failed error_code:105 error_msg:Failed to make progress."),
            LogLine(at, 30, "collision_monitor", "[scan]: timestamps differ on 1.09 seconds"),
            LogLine(at, 30, "collision_monitor", "[scan]: timestamps differ on 1.15 seconds"),
            LogLine(at, 40, "rosbridge_websocket", "[Client 44] /rosapi/fleet_tui_heartbeat does not exist"),
            LogLine(at, 40, "rosapi", "Timeout exceeded"),
        )
    )
    assert texts(counter, robots=1) == [
        "bt_navigator: ERROR Failed to make progress (error 105)",
        "collision_monitor: WARN [scan]: timestamps differ on 1.15 seconds",
    ]


def test_old_ones_do_not_count() -> None:
    at = now()
    counter = counter_of(
        PartDiagnosis(at, "robot_0: drive", ERROR, "no odometry"),
        log=(LogLine(at, 40, "/robot_0/drive", "wheels turn"),),
    )
    assert texts(counter, after=5) == ["drive: ERROR wheels turn", "drive: ERROR no odometry"]
    assert texts(counter, after=15) == ["drive: ERROR wheels turn"]
    assert texts(counter, after=65) == []


def test_an_error_precedes_an_unknown_cause_and_a_warning_stands_beside_it() -> None:
    planted = driving(then="stuck:robot_0").run(60)
    for level, names in (
        (ERROR, ["drive: ERROR no odometry"]),
        (WARN, ["drive: WARN no odometry", "stuck 60 s: cause unknown"]),
    ):
        counter = counter_of(PartDiagnosis(planted.now, f"{R0}: drive", level, "no odometry"))
        found = reasons(
            planted.state, planted.robot, complaints=complaints(planted.state, planted.robot, counter)
        )
        assert [one.name for one in found] == names
    assert found[0].seen == planted.now and found[0].keys == ("diagnostics",)


def test_beside_a_certain_cause_only_errors_count() -> None:
    planted = driving("paused:robot_0").run(5)
    drive = PartDiagnosis(planted.now, f"{R0}: drive", WARN, "brakes on")
    motor = PartDiagnosis(planted.now, f"{R0}: motor", ERROR, "hot")
    said = complaints(planted.state, planted.robot, counter_of(drive, motor))
    found = reasons(planted.state, planted.robot, complaints=said)
    assert [(one.name, one.strength) for one in found][:2] == [
        ("paused (elsewhere)", Strength.CERTAIN),
        ("motor: ERROR hot", Strength.LIKELY),
    ]
    assert "drive: WARN brakes on" not in [one.name for one in found]


def test_what_is_repeated_keeps_its_place() -> None:
    at = now()
    parts = [PartDiagnosis(at, f"robot_0: {part}", ERROR, "bad") for part in ("drive", "laser")]
    counter = counter_of(*parts, log=(LogLine(at, 40, "/robot_0/base", "slips"),))
    before = texts(counter)
    counter.take_health([PartDiagnosis(at + 1, "robot_0: laser", ERROR, "bad")])
    counter.take_log(LogLine(at + 1, 40, "/robot_0/base", "slips"))
    assert texts(counter) == before == ["base: ERROR slips", "drive: ERROR bad"]
