"""Faults planted in a simulated fleet: the true one is named first, and what helps with it."""

import math
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import structs

from fleet_tui.keys import KEYS
from fleet_tui.model.commands import (
    ClearOrders,
    Command,
    PauseRobot,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import (
    CargoReported,
    CommandAdvanced,
    CommandIssued,
    Event,
    FrameReceived,
    ObstacleReported,
    PausedReported,
    PoseReported,
)
from fleet_tui.model.geometry import Pose
from fleet_tui.rules.why.reason import Reason
from fleet_tui.rules.why.why import reasons
from fleet_tui.simulator.robot import SimOrder
from tests.support.fleets import (
    R0,
    T0,
    battery,
    commanded,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    tick,
    told,
)
from tests.support.planted_fleet import Planted

BASE, CONSUMIDORES, PACKING, CHARGER = 0, 19, 17, 15
AWAY = place_order(R0, CONSUMIDORES, BASE)
"""robot_0 waits at Base: this one it has to drive for."""
FROM_HERE = place_order(R0, BASE, CONSUMIDORES)


def driving(faults: str = "", command: Command = AWAY, then: str = "", **more: bool) -> Planted:
    """Three seconds into an order, and what happens then."""
    planted = Planted(faults, **more).run(1).command(command).run(3)
    planted.plant(then)
    return planted


def flat(planted: Planted, percent: float) -> Planted:
    planted.world.robots[R0].battery = percent
    return planted


def loaded(planted: Planted) -> Planted:
    planted.world.robots[R0].cargo = True
    return planted


def cut_off(planted: Planted) -> Planted:
    planted.tell(link_lost(planted.now))
    planted.deaf = True
    return planted


def unanswered(planted: Planted) -> Planted:
    planted.tell(CommandAdvanced(1, Stage.NO_ANSWER, planted.now, "in 5 s"))
    return planted


def behind_another(percent: float = 80.0) -> Planted:
    """robot_1 stands paused on the edge that robot_0 has to take: the site's traffic control holds it."""
    planted = flat(Planted("paused:robot_1").run(1), percent)
    one, other = planted.world.robots[R0], planted.world.robots["robot_1"]
    planted.command(AWAY).run(4)
    ahead = math.copysign(2.5, math.cos(one.pose.yaw)), math.copysign(2.5, math.sin(one.pose.yaw))
    turned_to_x = abs(math.cos(one.pose.yaw)) > 0.7
    other.pose = Pose(
        one.pose.x + (ahead[0] if turned_to_x else 0.0), one.pose.y + (0.0 if turned_to_x else ahead[1])
    )
    one.stuck = True
    return planted


def waiting_orders() -> Planted:
    """The robot's software lists orders and begins none."""
    planted = Planted("stuck:robot_0").run(1)
    planted.world.robots[R0].orders += [SimOrder(7, 0, 19), SimOrder(8, 19, 0)]
    planted.world.robots[R0].step = lambda: None  # type: ignore[method-assign]  # it does not even try
    return planted


SITUATIONS: dict[str, tuple[Callable[[], Planted], str]] = {
    "nothing to do": (lambda: Planted().run(3), "no orders"),
    "it drives": (lambda: driving(), "robot_0 is moving"),
    "paused elsewhere": (lambda: driving(then="paused").run(3), "paused"),
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
    "localisation lost": (lambda: driving(then="jumping:robot_0").run(6), "localisation jumps"),
    "stuck": (lambda: driving(then="stuck:robot_0").run(60), "cause unknown"),
    "stuck at the start": (
        lambda: driving("stuck:robot_0", FROM_HERE).run(60),
        "cause unknown",
    ),
    "loading": (lambda: Planted().run(1).command(FROM_HERE).run(2), "loading at Base"),
    "unloading": (
        lambda: loaded(Planted().run(1)).command(place_order(R0, BASE)).run(2),
        "unloading at Base",
    ),
    "cargo on board": (lambda: loaded(Planted()).run(3), "cargo without destination"),
    "refused": (lambda: driving("refuse"), "order: refused"),
    "no answer": (lambda: unanswered(driving("never").run(2)), "order: no answer"),
    "just sent": (lambda: driving("never"), "order: sent"),
    "cleared from here": (lambda: driving().command(ClearOrders(R0)).run(20), "no orders"),
    "its software restarted": (lambda: driving("restart").run(12), "order: lost"),
    "charging": (lambda: driving("battery:robot_0", quiet=False).run(120), "charging at Charger"),
    "flat, orders wait": (lambda: flat(waiting_orders(), 6.0).run(3), "battery 6 %"),
    "orders wait": (lambda: waiting_orders().run(3), "2 orders queued but not started"),
    "another robot ahead": (lambda: behind_another().run(40), "waiting behind robot_1"),
    "paused AND obstacle": (lambda: driving(then="paused:robot_0,obstacle:robot_0").run(9), "paused"),
    "offline AND flat": (lambda: flat(driving(then="silent:robot_0"), 9.0).run(9), "offline 9 s"),
    "offline AND paused": (lambda: driving("paused:robot_0", then="silent:robot_0").run(9), "offline 9 s"),
    "no link AND paused": (lambda: cut_off(driving("paused:robot_0")).run(9), "no link"),
    "obstacle AND low": (lambda: flat(driving(then="obstacle:robot_0"), 15.0).run(5), "obstacle 4."),
    "localisation lost AND low": (
        lambda: flat(driving(then="jumping:robot_0"), 15.0).run(6),
        "localisation jumps",
    ),
    "another robot ahead AND low": (lambda: behind_another(15.0).run(40), "waiting behind robot_1"),
    "no orders AND low": (lambda: flat(Planted(), 15.0).run(3), "no orders"),
    "paused AND pose stays away": (lambda: driving(then="paused:robot_0,stale:robot_0").run(9), "paused"),
    "obstacle AND another ahead": (lambda: _blocked(behind_another()).run(6), "obstacle 5."),
}


def _blocked(planted: Planted) -> Planted:
    planted.plant("obstacle:robot_0")
    return planted


# What no report tells: it is not loading for long, it is stuck.
KNOWN_MISSES = {"stuck at the start"}


def first(planted: Planted) -> Reason:
    return reasons(planted.state, planted.robot)[0]


@pytest.mark.parametrize("name", [name for name in SITUATIONS if name not in KNOWN_MISSES])
def test_the_planted_cause_is_listed_first(name: str) -> None:
    make, wanted = SITUATIONS[name]
    assert first(make()).name.startswith(wanted)


def test_what_is_missed_is_listed_all_the_same_and_is_rare() -> None:
    assert len(KNOWN_MISSES) < len(SITUATIONS) / 10
    for name in KNOWN_MISSES:
        make, wanted = SITUATIONS[name]
        planted = make()
        assert wanted in [reason.name for reason in reasons(planted.state, planted.robot)]


def test_a_pause_names_where_it_came_from_and_the_key() -> None:
    elsewhere = first(driving(then="paused").run(3))
    assert (elsewhere.evidence, elsewhere.keys) == (
        "reported by the robot, not sent by this console",
        ("resume",),
    )
    planted = driving().command(PauseRobot(R0))
    at = planted.now
    here = first(planted.run(3))
    assert here.evidence == "reported by the robot, sent by this console"
    assert here.since == pytest.approx(at)


def test_a_refusal_stands_in_the_robots_own_words_for_half_a_minute() -> None:
    planted = driving("refuse")
    assert first(planted).evidence == "REJECTED: the simulator was asked to refuse"
    assert first(planted.run(40)).name == "no orders"


def test_a_refused_resume_is_named_beside_the_pause() -> None:
    facts = commanded(1, ResumeRobot(R0), Stage.SENT, Stage.REFUSED, words="key switch is off")
    state = told(fleet(), link_up(T0), PausedReported(R0, T0, True), pose(T0), *facts, tick(T0 + 2))
    found = reasons(state, state.robots[R0])
    assert [reason.name for reason in found][:2] == ["paused", "resume: refused"]
    assert found[1].evidence == "key switch is off"


def test_two_robots_in_each_others_way_are_said_to_be() -> None:
    planted = behind_another().run(2)
    other = planted.world.robots["robot_1"]
    other.cargo, other.orders = True, [SimOrder(9, CONSUMIDORES, BASE, status="W")]
    found = first(planted.run(2))
    assert found.evidence.startswith("robot_1 is 2.")
    assert found.evidence.endswith("each blocks the other")
    assert found.keys == ("robot_2",)


def test_poses_that_come_late_are_told_from_poses_that_stay_away() -> None:
    """A clogged way: each pose is ten seconds old when it arrives, everything else is fresh."""
    fresh = [pose(T0 + n / 10, stamp=n / 10) for n in range(20)]
    late = [pose(T0 + 12 + n / 10, stamp=2 + n / 10) for n in range(20)]
    state = told(fleet(), link_up(T0), *fresh, *late, battery(T0 + 14), queue(T0 + 14), tick(T0 + 14))
    found = reasons(state, state.robots[R0])[0]
    assert (found.name, found.evidence) == ("pose 10 s old", "poses arrive late: their time stamps lag")


def test_an_idle_robot_at_the_charger_has_no_orders_first() -> None:
    planted = driving("battery:robot_0", ClearOrders(R0), quiet=False).run(120)
    names = [reason.name for reason in reasons(planted.state, planted.robot)]
    assert names == ["no orders", "charging at Charger", "battery 8 %"]


def test_one_correction_of_the_pose_is_no_jumping() -> None:
    state = told(fleet(), link_up(T0), pose(T0), pose(T0 + 0.1, x=30.0), queue(T0), tick(T0 + 2))
    assert [reason.name for reason in reasons(state, state.robots[R0])] == ["no orders"]
    assert len(state.robots[R0].jumps) == 1


def test_a_fast_robot_and_a_long_silence_are_no_jumps() -> None:
    state = told(fleet(), *(pose(T0 + n / 10, x=0.4 * n) for n in range(50)), pose(T0 + 60, x=90.0))
    assert state.robots[R0].jumps == ()


def test_leaps_of_long_ago_are_forgotten() -> None:
    leaps = [pose(T0 + n, x=20.0 * (n % 2)) for n in range(5)]
    still = [pose(T0 + 5 + n) for n in range(12)]
    state = told(fleet(), link_up(T0), *leaps, *still, queue(T0 + 16), tick(T0 + 16.5))
    assert [reason.name for reason in reasons(state, state.robots[R0])] == ["no orders"]


def test_robots_in_different_frames_are_not_compared() -> None:
    """The other's map lies elsewhere: its numbers mean another place."""
    planted = behind_another()
    frame = planted.state.robots["robot_1"].charts["floor_0"].frame
    assert frame is not None
    moved = structs.replace(frame, origin=Pose(frame.origin.x + 5.0, frame.origin.y))
    planted.run(3)
    assert first(planted).name == "waiting behind robot_1"
    planted.tell(FrameReceived("robot_1", "floor_0", moved))
    assert first(planted).name == "cause unknown"


def test_a_robot_beside_or_behind_is_not_in_the_way() -> None:
    here: list[Event] = [link_up(T0), graph(1, 2, 3), pose(T0, x=0.2), queue(T0, (1, 3, 1, "W"), current=1)]
    for x, y, waits in [(1.5, 0.0, True), (1.5, 1.2, False), (-0.5, 0.0, False), (1.5, 0.5, True)]:
        state = told(fleet(2), *here, PoseReported("robot_1", T0, Pose(x, y), "floor_0", None), tick(T0 + 2))
        names = [reason.name for reason in reasons(state, state.robots[R0])]
        assert ("waiting behind robot_1" in names) is waits, (x, y)


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
@settings(max_examples=300)
def test_whatever_was_heard_there_is_a_reason_and_every_key_exists(facts: list[Event], later: float) -> None:
    given = [CommandIssued(n, one, T0, 0.0) for n, one in enumerate(GIVEN, 1)]
    state = told(fleet(2), *given, *facts, tick(T0 + later))
    found = reasons(state, state.robots[R0])
    assert found
    strengths = [reason.strength for reason in found]
    if state.is_online(state.robots[R0]):
        assert strengths == sorted(strengths)
    assert {id_ for reason in found for id_ in reason.keys} <= {key.id for key in KEYS}
    if found[0].name == "robot_0 is moving":
        assert len(found) == 1
    names = [reason.name for reason in found]
    assert ("paused" in names or "paused (by us)" in names) is (
        state.is_paused(state.robots[R0]) and names != ["robot_0 is moving"]
    )


@pytest.mark.parametrize(
    ("stages", "name"),
    [
        ([Stage.SENT], "pause from this console: sent"),
        ([Stage.SENT, Stage.NO_ANSWER], "pause from this console: no answer"),
        ([Stage.SENT, Stage.UNKNOWN], "pause from this console: outcome unknown"),
    ],
)
def test_a_pause_from_here_that_may_hold_it_is_named_with_the_key(stages: list[Stage], name: str) -> None:
    facts = commanded(1, PauseRobot(R0), *stages)
    still: list[Event] = [pose(T0 - 9), pose(T0 + 1), queue(T0 + 1, (1, 1, 2, "W"), current=1)]
    state = told(fleet(), link_up(T0 - 9), *facts, *still, tick(T0 + 2))
    found = reasons(state, state.robots[R0])
    assert found[0].name == name and found[0].keys == ("resume",)


def test_a_pause_that_was_obeyed_late_is_named() -> None:
    facts = commanded(1, PauseRobot(R0), Stage.SENT, Stage.NO_ANSWER)
    state = told(fleet(), link_up(T0 - 9), pose(T0 - 9), *facts, pose(T0 + 6), tick(T0 + 6))
    assert state.commands[0].stage is Stage.NOT_CONFIRMED
    assert "pause from this console: not confirmed" in [one.name for one in reasons(state, state.robots[R0])]
    state = told(state, CommandAdvanced(1, Stage.ACCEPTED, T0 + 12, "paused"), pose(T0 + 12), tick(T0 + 12))
    assert reasons(state, state.robots[R0])[0].name == "paused (by us)"
