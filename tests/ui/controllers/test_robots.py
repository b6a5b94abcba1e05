"""Requests to robots beside orders: pauses of one or all, and the menu of a robot."""

from fleet_tui.model.commands import PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, CommandPathChanged, PausedReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions, Right
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.ordering.orders import OrderRequests
from fleet_tui.ui.controllers.robots import RobotRequests
from fleet_tui.ui.widgets.rows_pane import RowsPane
from tests.support.desk import Desk, ready
from tests.support.fleets import LINK, R0, T0, battery, fleet, link_up, reduced, tick
from tests.support.kinds import FULL, MUTE, moved

ALIVE = CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)


def requests(
    state: FleetState, permissions: Permissions | None = None
) -> tuple[Desk, list[str], RobotRequests]:
    desk, asked = Desk(state, permissions), list[str]()
    orders = OrderRequests(
        desk.console(),
        queue=RowsPane(id="queue"),
        open_form=lambda _robot, _place, _way: None,
        marked=desk.marked,
    )
    return (
        desk,
        asked,
        RobotRequests(
            desk.console(),
            orders=orders,
            why=lambda: asked.append(desk.navigation.robot),
            alarm_menu=lambda source, kind: asked.append(f"{kind} of {source}"),
            marked=desk.marked,
        ),
    )


def test_a_pause_leaves_at_once() -> None:
    desk, _, robots = requests(ready())
    robots.pause()
    robots.resume()
    robots.pause_all()
    assert desk.backend.submitted == [PauseRobot(R0), ResumeRobot(R0), PauseRobot(R0)]
    assert desk.answers == []


def test_resume_all_asks_once_and_reaches_whom_a_pause_holds() -> None:
    other = "robot_1"
    heard = (PausedReported(R0, T0, True), PausedReported(other, T0, False), tick(T0))
    desk, _, robots = requests(reduced(fleet(2), link_up(T0), ALIVE, *heard))
    robots.resume_all()
    assert (len(desk.answers), desk.backend.submitted) == (1, [])
    desk.say_yes()
    assert desk.backend.submitted == [ResumeRobot(R0)]


def test_resume_all_counts_whom_others_paused() -> None:
    names = ("robot_0", "robot_1", "robot_2")
    state = reduced(
        fleet(3), link_up(T0), ALIVE, *(PausedReported(name, T0, True) for name in names), tick(T0)
    )
    desk, _, robots = requests(
        reduced(state, CommandIssued(1, PauseRobot(R0), T0, 1.7e9), CommandAdvanced(1, Stage.SENT, T0))
    )
    robots.resume_all()
    assert "2 paused elsewhere: robot_1, robot_2" in desk.asked[-1]


def test_resume_all_says_so_where_no_robot_is_paused() -> None:
    desk, _, robots = requests(ready())
    robots.resume_all()
    assert (desk.answers, desk.backend.submitted) == ([], [])
    assert desk.notices.text == "no robot is paused"


def test_the_menu_leads_to_the_alarms_of_the_robot() -> None:
    desk, asked, robots = requests(reduced(ready(), battery(T0, 5.0), tick(T0)))
    robots.menu(R0)
    (menu,) = desk.menus
    assert menu.texts[-1] == "Alarm: battery 5 % ..."
    assert menu.texts[menu.marked] == "Explain why it is not moving (w)"
    menu.choose("Alarm: battery 5 % ...")
    assert asked == [f"battery of {R0}"]


def test_the_menu_has_what_the_robot_accepts() -> None:
    desk, asked, robots = requests(moved(FULL, MUTE))
    robots.menu("robot_0")
    robots.menu("robot_1")
    full, mute = desk.menus
    assert full.texts[:4] == ["Order (o)", "Pause (p)", "Resume (r)", "Clear all orders (X)"]
    assert full.marked == 0, "nothing is wrong with it"
    assert mute.texts == ["Show on the map", "Explain why it is not moving (w)"]
    mute.choose("Explain")
    assert asked == ["robot_1"], "the robot of the menu is the selected one then"


def test_the_newest_fault_stands_above_the_menu() -> None:
    from fleet_tui.model.events import MessageRejected
    from tests.support.fleets import reduced

    desk, _, robots = requests(reduced(ready(), MessageRejected(R0, Message("no  pose"))))
    robots.menu(R0)
    assert desk.menus[0].title == f"{R0}: no ␛ pose"


def test_who_may_only_view_has_a_menu_without_commands_and_can_not_pause() -> None:
    desk, _, robots = requests(ready(), Permissions(right=Right.VIEW))
    robots.menu(R0)
    assert desk.menus[0].texts[:2] == ["Show on the map", "Explain why it is not moving (w)"]
    robots.pause()
    assert desk.notices.text == "not allowed: dispatch"
    robots.pause_all()
    robots.resume_all()
    assert (desk.backend.submitted, desk.answers) == ([], [])
