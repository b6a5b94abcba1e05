"""Reasons that lie in a robot's orders."""

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import CHECK_DELIVERY, ORDER_ENDS, ClearOrders, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.model.order import Order, at_vertices
from fleet_tui.model.order_life import GoneOrder
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.causes import HELD_FAST, NO_WAY
from fleet_tui.situation.failures import REJECTED
from fleet_tui.situation.why.orders import RESTART
from fleet_tui.situation.why.reason import LOOK_AT, Reason
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from tests.support.fleets import F0, LINK, R0, T0, commanded, place_order, pose, queue, reduced, tick
from tests.support.kinds import FULL, GOALS, moved
from tests.support.planted_fleet import Planted
from tests.support.situations import AWAY, driving, first, flat, names

KEEPS = replace(GOALS, keeps_goals=True)


def test_a_refusal_stands_in_the_robots_own_words_for_half_a_minute() -> None:
    planted = driving("refuse")
    assert first(planted).evidence == "REJECTED: the simulator was asked to refuse"
    assert first(planted.run(40)).name == "no orders"


@pytest.mark.parametrize("kind", [KEEPS, FULL])
@pytest.mark.parametrize(
    "stages",
    [
        (Stage.REFUSED,),
        (Stage.ACCEPTED, Stage.NOT_CONFIRMED),
        (Stage.ACCEPTED, Stage.CONFIRMED, Stage.FAILED),
        (Stage.ACCEPTED, Stage.CONFIRMED, Stage.LOST),
    ],
)
def test_the_reason_of_an_order_that_failed_and_its_alarm_advise_the_same(
    kind: Kind, stages: tuple[Stage, ...]
) -> None:
    given = commanded(1, place_order(R0, 1, 2), Stage.SENT, *stages, at=T0 + 9, detail="no path to the goal")
    state = reduced(moved(kind), pose(T0 + 9), queue(T0 + 9), *given, tick(T0 + 9))
    (alarm,) = [one for one in state.alarms if one.condition.kind == "command"]
    found = reasons(state, state.robots[R0])[0]
    assert (found.name, found.remedy) == (f"{stages[-1].value}: order", action_of(alarm.condition))
    is_rejected = kind is KEEPS and stages == (Stage.REFUSED,)
    assert (found.remedy == REJECTED) is is_rejected, "the servers of a kind with goals may be inactive"


def test_after_an_own_order_without_progress_w_offers_to_look_at_the_robot() -> None:
    given = commanded(1, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, at=T0 + 8)
    cause = "Failed to find a valid control. Even after executing recovery behaviors."
    for detail, offered in ((cause, True), ("unplugged", False)):
        end = CommandAdvanced(1, Stage.FAILED, T0 + 9, detail=Message(detail))
        failed = reduced(moved(GOALS), pose(T0 + 9), queue(T0 + 9), *given, end, tick(T0 + 9))
        keys = reasons(failed, failed.robots[R0])[0].keys
        assert ({*LOOK_AT, "diagnostics"} <= {*keys}) == offered and "order" in keys


def test_orders_that_are_not_listed_any_more_are_why_a_robot_stands() -> None:
    order = queue(T0, (4, 1, 2, "W"), current=4)
    still = reduced(moved(FULL), pose(T0), order, tick(T0 + 1))
    gone = reduced(still, *(pose(T0 + n) for n in range(2, 31)), tick(T0 + 30))
    found = reasons(gone, gone.robots[R0])[0]
    assert (found.name, found.remedy, found.keys) == ("queue 30 s old", RESTART, ("diagnostics",))
    listed = reduced(gone, queue(T0 + 30, (4, 1, 2, "W"), current=4), tick(T0 + 30))
    late = replace(gone, links={LINK: replace(gone.links[LINK], late=9.0)})  # its bridge explains it
    for state in (listed, late):
        assert not any(one.name.startswith("queue") for one in reasons(state, state.robots[R0]))


def test_that_it_charges_explains_a_low_battery_and_that_it_has_no_order() -> None:
    planted = driving("battery:robot_0", ClearOrders(R0), quiet=False).run(120)
    (only,) = reasons(planted.state, planted.robot)
    assert (only.name, only.remedy, only.keys) == ("charging at Charger", "Wait: it is charging", ())


def test_a_robot_that_stands_at_its_charger_with_an_order_is_not_sent_there() -> None:
    planted = Planted().run(1)
    graph = planted.robot.maps[F0].graph
    assert graph is not None
    (charger,) = graph.chargers
    robot = flat(planted, 9.0).world.robots[R0]
    robot.pose, robot.stuck = Pose(charger.x, charger.y), True
    planted.run(3).command(AWAY).run(12)
    assert "Send it to a charger" not in {one.remedy for one in reasons(planted.state, planted.robot)}
    (alarm,) = (one for one in planted.state.alarms if one.key == (R0, "battery"))
    assert action_of(alarm.condition) == "Check the robot and its charger"


def test_a_robot_without_cargo_does_not_load() -> None:
    order = (1, 1, 2, "W")
    for kind, name in ((GOALS, "waiting 8 s, nothing wrong so far"), (FULL, "loading at 1")):
        driving = reduced(
            moved(kind), queue(T0 + 1, order, current=1), pose(T0 + 9), queue(T0 + 9, order, current=1)
        )
        assert name in names(reduced(driving, tick(T0 + 9)))


def test_the_order_that_failed_last_is_why_a_robot_has_none() -> None:
    order = Order("7", at_vertices("1", "2"), None, "", 1)
    idle = reduced(moved(GOALS), queue(T0 + 9), pose(T0 + 9), tick(T0 + 9))

    def after(stage: Stage, cause: str = "unplugged") -> Reason:
        gone = GoneOrder(order, T0, stage, Message(cause))
        return reasons(idle, replace(idle.robots[R0], gone=(gone,)))[0]

    assert (after(Stage.FAILED).name, after(Stage.FAILED).since) == ("last order failed: unplugged", T0)
    for cause in ("Failed to make progress", "no valid control. Even after executing recovery behaviors."):
        assert after(Stage.FAILED, cause).remedy == HELD_FAST != after(Stage.FAILED).remedy
    for cause in (
        "no path to the goal",
        "Failed to find a valid plan. Even after executing recovery behaviors.",
    ):
        assert after(Stage.FAILED, cause).remedy == NO_WAY
    assert after(Stage.FAILED).page == "log" and "diagnostics" in after(Stage.FAILED).keys
    assert (after(Stage.LOST).name, after(Stage.LOST).remedy) == ("last order lost", CHECK_DELIVERY)
    left = after(Stage.LEFT)
    assert (left.name, left.remedy) == ("last order left the queue", ORDER_ENDS[Stage.LEFT].remedy)
    assert "order again" not in left.remedy
    assert after(Stage.DONE).name == "no orders"
