"""Faults of robots with Nav2."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from fleet_tui.simulator.faults import FAULTS as OF_ALL
from fleet_tui.simulator.faults import wire

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.nav2.fleet import Nav2Fleet
    from fleet_tui.simulator.nav2.navigation import Navigation
    from fleet_tui.simulator.server import RosbridgeServer

ABORTS = 105  # Nav2's code for no progress
AWHILE = 3.0  # seconds after which something happens to a drive
EVERY = 20.0  # seconds between two goals of another client
FLAT = 8.0  # per cent above which `battery` never charges
GENERIC = (
    *("late", "slow-answer", "twice", "wrong-id", "drop"),
    *("frozen-rosapi", "dead-rosapi", "overloaded", "unregistered"),
)


def _fleet(server: "RosbridgeServer", robot: str) -> "Nav2Fleet":
    from fleet_tui.simulator.nav2.fleet import Nav2Fleet

    fleet = server.fleet_of(robot)
    assert isinstance(fleet, Nav2Fleet)
    return fleet


def _navigation(server: "RosbridgeServer", robot: str) -> "Navigation":
    return _fleet(server, robot).navigation[robot]


def _set(change: Callable[["Navigation"], None]) -> wire.Play:
    """A fault that is there from the start."""
    return lambda server, robot: change(_navigation(server, robot))


def _often(change: Callable[["Navigation", float], float], idle: bool = False) -> wire.Play:
    """A fault that happens again and again: `change` is told the seconds for which there has been a goal, or
    where `idle` those since it happened, and returns what is left of them."""

    def play(server: "RosbridgeServer", robot: str) -> None:
        navigation, age = _navigation(server, robot), 0.0

        def step(dt: float) -> None:
            nonlocal age
            busy = idle or any(one.running for one in navigation.servers.values())
            age = change(navigation, age + dt / server.speed if busy else 0.0)

        server.fleet_of(robot).troubles.append(step)

    return play


def _inactive(navigation: "Navigation") -> None:
    navigation.active = False


def _reject(navigation: "Navigation") -> None:
    navigation.reject = 10**9


def _aborts(navigation: "Navigation", age: float) -> float:
    if age < AWHILE:
        return age
    navigation.abort(ABORTS)
    return 0.0


def _refuse_cancel(navigation: "Navigation") -> None:
    for server in navigation.servers.values():
        server.refuses_cancel = True


def _foreign_goal(navigation: "Navigation", age: float) -> float:
    if age < EVERY:
        return age
    floor, at = navigation.robot.floor, navigation.robot.pose
    far = max(floor.labels, key=lambda id_: abs(floor.graph.vertices[id_].x - at.x))
    navigation.give(floor.graph.vertices[far].x, floor.graph.vertices[far].y)
    return 0.0


def _foreign_cancel(navigation: "Navigation", age: float) -> float:
    if age < AWHILE:
        return age
    for server in navigation.servers.values():
        server.cancel(bytes(16), 0)
    return 0.0


def _dead_server(server: "RosbridgeServer", robot: str) -> None:
    """Let the node of the action servers crash in the middle of the first goal."""

    def change(navigation: "Navigation", age: float) -> float:
        if age > AWHILE:
            for one in navigation.servers.values():
                one.die()
                server.silent_services.add(f"{one.name}/_action/cancel_goal")
        return age

    _often(change)(server, robot)


def _no_feedback(navigation: "Navigation") -> None:
    navigation.tells = False


def _no_odom(navigation: "Navigation") -> None:
    navigation.robot.odometry = False


def _lost(navigation: "Navigation") -> None:
    navigation.robot.lose()


def _obstacle(navigation: "Navigation") -> None:
    navigation.robot.block()


def _stuck(navigation: "Navigation") -> None:
    navigation.robot.stuck = True


def _silent(navigation: "Navigation") -> None:
    navigation.robot.silence = float("inf")


def _battery(navigation: "Navigation", age: float) -> float:
    navigation.robot.battery = min(navigation.robot.battery, FLAT)
    return age


def _unmeasured(navigation: "Navigation") -> None:
    navigation.robot.percent = float("nan")


def _percent(navigation: "Navigation") -> None:
    navigation.robot.percent = 1.0


def _unsourced(server: "RosbridgeServer", _robot: str) -> None:
    server.unsourced.add("nav2_msgs")


def _mute_rejection(server: "RosbridgeServer", _robot: str) -> None:
    server.actions.tells_failure = False


def _humble(server: "RosbridgeServer", robot: str) -> None:
    """Let the bridge be Humble's, with its usual parameters."""
    server.one_by_one, server.call_timeout = True, None
    server.rosapi.distro = "humble"
    for navigation in _fleet(server, robot).navigation.values():
        navigation.distro = "humble"


FAULTS: Mapping[str, tuple[str, wire.Play]] = {
    "inactive": ("Nav2 is not active: every goal is rejected, and is_active says so", _set(_inactive)),
    "reject": ("every goal is rejected though Nav2 is active", _set(_reject)),
    "aborts": (f"every drive is aborted with code {ABORTS} after {AWHILE:g} s", _often(_aborts)),
    "stuck": ("its wheels stand still: no ETA, recoveries, then an abort", _set(_stuck)),
    "foreign-goal": (f"another client gives it a goal every {EVERY:g} s", _often(_foreign_goal, idle=True)),
    "foreign-cancel": (f"another client cancels every goal after {AWHILE:g} s", _often(_foreign_cancel)),
    "refuse-cancel": ("no goal can be cancelled", _set(_refuse_cancel)),
    "dead-server": (f"its action servers crash {AWHILE:g} s after the first goal", _dead_server),
    "no-feedback": ("its actions say nothing on the way", _set(_no_feedback)),
    "no-odom": ("it has no odometry", _set(_no_odom)),
    "lost": ("its localisation is not sure where it is, and wrong", _set(_lost)),
    "obstacle": ("the collision monitor stops it before an obstacle that stays", _set(_obstacle)),
    "battery": (f"a battery that never holds more than {FLAT:g} %", _often(_battery, idle=True)),
    "unmeasured": ("its battery's percentage is not measured: NaN", _set(_unmeasured)),
    "percent": ("its battery's percentage is 0 to 100 instead of 0 to 1", _set(_percent)),
    "silent": ("nothing is heard of it", _set(_silent)),
    "humble": (
        "the bridge of Humble: a goal or a call blocks its connection until it is over, no time limit",
        _humble,
    ),
    "mute-rejection": ("an old bridge: a goal that is rejected is never answered", _mute_rejection),
    "unsourced": ("the bridge lacks the package nav2_msgs", _unsourced),
    "never": ("its services never answer and do nothing", wire.never),
} | {name: OF_ALL[name] for name in GENERIC}
"""Each fault by its name: the text of the help, and how it is played on one robot."""
