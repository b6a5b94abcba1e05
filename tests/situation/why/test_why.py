"""Faults planted in a simulated fleet: the true one is named first, and what helps with it."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.keys import KEYS
from fleet_tui.model.commands import ClearOrders, Command, PauseRobot, Stage
from fleet_tui.model.events import (
    CargoReported,
    CommandAdvanced,
    CommandIssued,
    Event,
    ObstacleReported,
    PausedReported,
)
from fleet_tui.model.kind import Kind
from fleet_tui.simulator.robot import SimOrder
from fleet_tui.situation.pose_checks.match import Match
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.situation.why.orders import SHORT
from fleet_tui.situation.why.reason import Reason
from fleet_tui.situation.why.why import reasons
from fleet_tui.text.language import Message
from tests.support.fleets import (
    R0,
    T0,
    battery,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.kinds import FULL, MUTE, moved
from tests.support.planted_fleet import Planted
from tests.support.situations import AWAY, BASE, CONSUMIDORES, behind_another, driving, first, flat, names

FROM_HERE = place_order(R0, BASE, CONSUMIDORES)


def loaded(planted: Planted) -> Planted:
    planted.world.robots[R0].cargo = True
    return planted


def cut_off(planted: Planted) -> Planted:
    planted.tell(link_lost(planted.now))
    planted.deaf = True
    return planted


def unanswered(planted: Planted) -> Planted:
    planted.tell(CommandAdvanced(1, Stage.NO_ANSWER, planted.now, Message("in 5 s")))
    return planted


def waiting_orders() -> Planted:
    """The robot's software lists orders and begins none."""
    planted = Planted("stuck:robot_0").run(1)
    planted.world.robots[R0].orders += [SimOrder(7, 0, 19), SimOrder(8, 19, 0)]
    planted.world.robots[R0].step = lambda: None  # type: ignore[method-assign]  # it does not even try
    return planted


SITUATIONS: dict[str, tuple[Callable[[], Planted], str]] = {
    "nothing to do": (lambda: Planted().run(3), "no orders"),
    "it drives": (lambda: driving(), "robot_0 is driving"),
    "paused elsewhere": (lambda: driving(then="paused").run(3), "paused (elsewhere)"),
    "paused from here": (lambda: driving().command(PauseRobot(R0)).run(3), "paused"),
    "paused, no topic tells": (
        lambda: driving(tells_pause=False).command(PauseRobot(R0)).run(3),
        "paused (by us)",
    ),
    "obstacle": (lambda: driving(then="obstacle:robot_0").run(5), "obstacle 4."),
    "a contact of two seconds": (lambda: driving(then="obstacle:robot_0").run(2), "obstacle 1."),
    "gone silent": (lambda: driving(then="silent:robot_0").run(9), "offline 9 s"),
    "silent from the start": (lambda: Planted("silent:robot_0").run(9), "never seen"),
    "no link": (lambda: cut_off(driving()).run(9), "no link"),
    "pose stays away": (lambda: driving(then="stale:robot_0").run(9), "pose 9 s old"),
    "localisation lost": (lambda: driving(then="jumping:robot_0").run(6), "pose jumps"),
    "stuck": (lambda: driving(then="stuck:robot_0").run(60), "stuck 60 s: cause unknown"),
    "stuck at the start": (lambda: driving("stuck:robot_0", FROM_HERE).run(62), "stuck 66 s: cause unknown"),
    "loading": (lambda: Planted().run(1).command(FROM_HERE).run(2), "loading at Base"),
    "unloading": (
        lambda: loaded(Planted().run(1)).command(place_order(R0, BASE)).run(2),
        "unloading at Base",
    ),
    "cargo on board": (lambda: loaded(Planted()).run(3), "cargo without destination"),
    "refused": (lambda: driving("refuse"), "refused: order"),
    "no answer": (lambda: unanswered(driving("never").run(2)), "order: no answer"),
    "just sent": (lambda: driving("never"), "order: sent"),
    "cleared from here": (lambda: driving().command(ClearOrders(R0)).run(20), "no orders"),
    "its software restarted": (lambda: driving("restart").run(12), "lost: order"),
    "charging": (lambda: driving("battery:robot_0", quiet=False).run(120), "charging at Charger"),
    "flat, orders wait": (lambda: flat(waiting_orders(), 6.0).run(3), "battery 6 %"),
    "orders wait": (lambda: waiting_orders().run(3), "2 orders queued but not started"),
    "another robot ahead": (lambda: behind_another().run(40), "waiting behind robot_1"),
    "paused AND obstacle": (
        lambda: driving(then="paused:robot_0,obstacle:robot_0").run(9),
        "paused (elsewhere)",
    ),
    "offline AND flat": (lambda: flat(driving(then="silent:robot_0"), 9.0).run(9), "offline 9 s"),
    "offline AND paused": (lambda: driving("paused:robot_0", then="silent:robot_0").run(9), "offline 9 s"),
    "no link AND paused": (lambda: cut_off(driving("paused:robot_0")).run(9), "no link"),
    "obstacle AND low": (lambda: flat(driving(then="obstacle:robot_0"), 15.0).run(5), "obstacle 4."),
    "localisation lost AND low": (lambda: flat(driving(then="jumping:robot_0"), 15.0).run(6), "pose jumps"),
    "another robot ahead AND low": (lambda: behind_another(15.0).run(40), "waiting behind robot_1"),
    "no orders AND low": (lambda: flat(Planted(), 15.0).run(3), "no orders"),
    "paused AND pose stays away": (
        lambda: driving(then="paused:robot_0,stale:robot_0").run(9),
        "paused (elsewhere)",
    ),
    "obstacle AND another ahead": (lambda: _blocked(behind_another()).run(6), "obstacle 5."),
}


def _blocked(planted: Planted) -> Planted:
    planted.plant("obstacle:robot_0")
    return planted


LOGGED = ("stuck", "stuck at the start", "refused", "no answer", "just sent", "its software restarted")
PAGES = {"no link": "link", "no link AND paused": "link", "orders wait": "log"} | dict.fromkeys(LOGGED, "log")


@pytest.mark.parametrize("name", SITUATIONS)
def test_the_planted_cause_is_listed_first(name: str) -> None:
    make, wanted = SITUATIONS[name]
    planted = make()
    assert first(planted).name.startswith(wanted)
    assert first(planted).page == PAGES.get(name, "topics"), "where diagnostics opens"


def test_orders_that_a_certain_cause_holds_back_are_no_reason_of_their_own() -> None:
    planted = waiting_orders().run(1)
    assert "2 orders queued but not started" in names(planted.run(3).state)
    planted.plant("paused:robot_0")
    assert names(planted.run(6).state) == ["paused (elsewhere)"]


GIVEN: tuple[Command, ...] = (AWAY, ClearOrders(R0), PauseRobot(R0))

FACTS = st.one_of(
    st.builds(lambda x: pose(T0, x=x), st.floats(-50, 50)),
    st.builds(lambda percent: battery(T0, percent), st.floats(0, 100)),
    st.builds(lambda loaded: CargoReported(R0, T0, loaded), st.booleans()),
    st.builds(lambda seconds: ObstacleReported(R0, T0, seconds), st.floats(0, 60)),
    st.builds(lambda paused: PausedReported(R0, T0, paused), st.booleans()),
    st.builds(
        lambda orders, current: queue(T0, *orders, current=current),
        st.lists(
            st.tuples(st.integers(0, 5), st.integers(0, 4), st.integers(0, 4), st.sampled_from("WQDC?"))
        ),
        st.integers(-1, 5),
    ),
    st.sampled_from(
        [graph(1, 2, 3), labels({1: "Base"}), link_up(T0), link_lost(T0), pose(T0, robot="robot_1")]
    ),
    st.builds(
        lambda id_, stage, after: CommandAdvanced(id_, stage, T0 + after),
        st.integers(1, 3),
        st.sampled_from(Stage),
        st.floats(0, 9),
    ),
)


@given(st.lists(FACTS, max_size=25), st.floats(0, 20))
def test_whatever_was_heard_there_is_a_reason_and_every_key_exists(facts: list[Event], later: float) -> None:
    given = [CommandIssued(n, one, T0, 0.0) for n, one in enumerate(GIVEN, 1)]
    state = reduced(fleet(2), *given, *facts, tick(T0 + later))
    found = reasons(state, state.robots[R0])
    assert found
    strengths = [reason.strength for reason in found]
    if state.is_online(state.robots[R0]):
        assert strengths == sorted(strengths)
    assert {id_ for reason in found for id_ in reason.keys} <= {key.id for key in KEYS}
    if found[0].name == "robot_0 is driving":
        assert len(found) == 1
    names = [reason.name for reason in found]
    assert any(name.startswith("paused") for name in names) is (
        state.is_paused(state.robots[R0]) and names != ["robot_0 is driving"]
    )


def test_no_reason_is_made_of_what_is_never_reported() -> None:
    still = reduced(moved(MUTE), pose(T0 + 9), tick(T0 + 9))
    assert names(still) == ["cause unknown"]
    assert names(reduced(moved(Kind("silent")), battery(T0 + 9), tick(T0 + 9))) == ["cause unknown"]
    assert "queue unknown" in names(reduced(moved(FULL), pose(T0 + 9), tick(T0 + 9)))


def test_a_scan_that_does_not_fit_comes_first_and_without_one_nothing_is_said() -> None:
    state = fleet()
    state = reduced(state, link_up(T0 - 100), pose(T0 - 60), pose(T0 - 0.1), queue(T0 - 0.1), tick(T0))
    robot = state.robots[R0]
    assert "not localised" not in [reason.name for reason in reasons(state, robot)]
    assert reasons(state, robot, Match(0.9, 0.05, 600)) == reasons(state, robot)
    first = reasons(state, robot, Match(0.1, 1.5, 600))[0]
    assert first.name == "not localised"
    assert first.evidence == "10 % of 600 beams fit the map, median 1.50 m"


def test_a_scan_that_does_not_fit_is_told_also_of_a_robot_that_moves() -> None:
    state = reduced(fleet(), link_up(T0 - 100), pose(T0 - 0.5), pose(T0 - 0.1, 0.4), queue(T0), tick(T0))
    robot = state.robots[R0]
    assert reasons(state, robot)[0].name == "robot_0 is driving"
    assert reasons(state, robot, Match(0.1, 1.5, 600))[0].name == "not localised"


def test_what_a_robot_reports_about_itself_comes_after_jumps_of_its_pose() -> None:
    planted = driving(then="jumping:robot_0").run(12)
    own = Complaint(Message("drive: ERROR no odometry"), "diagnostics", True, planted.now)
    found = [one.name for one in reasons(planted.state, planted.robot, complaints=[own])]
    assert found[0].startswith("pose jumps: 1") and found[0].endswith(" in 10 s")
    assert found[1] == own.text


def test_a_low_battery_comes_after_the_lack_of_orders() -> None:
    """That is certain, and why the robot does not drive now."""
    low = flat(Planted(), 6.0)
    assert names(low.run(3).state)[:2] == ["no orders", "battery 5 %"]


def test_who_has_just_stopped_is_not_sent_for_until_it_stands_for_longer() -> None:
    def first(seconds: float) -> Reason:
        planted = driving(then="stuck:robot_0").run(seconds)
        return reasons(planted.state, planted.robot)[0]

    assert first(5).name.startswith("waiting ") and first(5).remedy == ""
    assert first(SHORT + 2).name == "waiting 22 s: cause unknown" and "wheels" in first(SHORT + 2).remedy
