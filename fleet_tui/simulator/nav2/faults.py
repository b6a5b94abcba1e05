"""Faults of robots with Nav2."""

from typing import TYPE_CHECKING

from fleet_tui.simulator.faults import FAULTS as OF_ALL
from fleet_tui.simulator.faults import wire
from fleet_tui.simulator.faults.plays import Faults, each_step, having
from fleet_tui.simulator.navigating.faults import AWHILE, BODY, navigation_of, often

if TYPE_CHECKING:
    # The command line lists the faults: it must not wait for the server to be imported.
    from fleet_tui.simulator.nav2.navigation import SimNavigation
    from fleet_tui.simulator.server import RosbridgeServer

ABORTS = 105  # Nav2's code for no progress
LATE_CONTROLLER = (
    "bt_navigator_navigate_to_pose_rclcpp_node",
    "Timed out while waiting for action server to acknowledge goal request for follow_path",
)
DEAD_CONTROLLER = (
    "lifecycle_manager_navigation",
    "CRITICAL FAILURE: SERVER controller_server IS DOWN after not receiving a heartbeat for 4000 ms. Shutting"
    " down related nodes.",
)
GENERIC = (
    "late",
    "slow-answer",
    "twice",
    "wrong-id",
    "drop",
    "frozen-rosapi",
    "dead-rosapi",
    "half-dead",
    "topics-glob",
    "services-glob",
    "actions-glob",
    "overloaded",
    "unregistered",
)


def _aborts(navigation: "SimNavigation") -> None:
    navigation.abort(ABORTS)


def _silent_aborts(navigation: "SimNavigation") -> None:
    """Abort as a behaviour tree does whose controller is late: no code, no text, a warning in the log."""
    navigation.warn(*LATE_CONTROLLER)
    navigation.abort(0, "")


def _refuse_cancel(server: "RosbridgeServer", robot: str) -> None:
    for action in navigation_of(server, robot).servers.values():
        action.refuses_cancel = True


def _dead_server(server: "RosbridgeServer", robot: str) -> None:
    """Crash the node of the action servers during the first goal."""

    def die(navigation: "SimNavigation") -> None:
        for action in navigation.servers.values():
            action.die()
            server.bridge.services.silent_services.add(f"{action.name}/_action/cancel_goal")

    often(die)(server, robot)


def _mute_rejection(server: "RosbridgeServer", _robot: str) -> None:
    server.bridge.services.actions.reports_failure = False


def _humble(server: "RosbridgeServer", robot: str) -> None:
    """Make the bridge that of Humble, with its default parameters."""
    server.bridge.one_by_one = True
    server.bridge.services.call_timeout = None
    server.bridge.services.rosapi.distro = "humble"
    for one in server.bridge.services.fleet_of(robot).robots:
        navigation_of(server, one).distro = "humble"


def _node_down(server: "RosbridgeServer", robot: str) -> None:
    """Kill the controller: the manager takes all other nodes down."""
    navigation: SimNavigation = navigation_of(server, robot)
    navigation.active = False
    navigation.warn(*DEAD_CONTROLLER, is_error=True)
    del server.bridge.services.offered[f"/{robot}/controller_server/get_state"]


def _bring_up(server: "RosbridgeServer", robot: str) -> None:
    """Let the planner wait for a pose, and the lifecycle manager for the planner."""
    navigation: SimNavigation = navigation_of(server, robot)
    manager = f"/{robot}/lifecycle_manager_navigation/is_active"
    navigation.waits_in = "planner_server"
    navigation.active = False
    navigation.robot.is_lost_at_start = True
    server.bridge.services.silent_services.add(manager)

    def step(_passed: float) -> None:
        if navigation.waits_in and not navigation.robot.is_lost_at_start:
            navigation.waits_in = ""
            navigation.active = True
            server.bridge.services.silent_services.discard(manager)

    each_step(server, robot, step)


def _foreign_spin(navigation: "SimNavigation") -> None:
    if not navigation.busy:
        navigation.take("spin", {"target_yaw": 30.0, "time_allowance": {"sec": 60, "nanosec": 0}})


FAULTS: Faults = {
    **BODY,
    "foreign-spin": ("another client lets it spin, again and again", often(_foreign_spin, idle=True)),
    "inactive": (
        "Nav2 not active: every goal is rejected, is_active is false",
        having(navigation_of, active=False),
    ),
    "node-down": ("its controller_server is dead, Nav2 not active", _node_down),
    "bring-up": ("Nav2 starts and waits for a pose, its manager does not answer", _bring_up),
    "reject": ("every goal is rejected though Nav2 is active", having(navigation_of, reject=10**9)),
    "aborts": (f"every drive is aborted with code {ABORTS} after {AWHILE:g} s", often(_aborts)),
    "silent-aborts": (
        f"every drive is aborted after {AWHILE:g} s without a code, only the log tells why",
        often(_silent_aborts),
    ),
    "refuse-cancel": ("no goal can be cancelled", _refuse_cancel),
    "dead-server": (f"its action servers crash {AWHILE:g} s after the first goal", _dead_server),
    "no-feedback": ("no action feedback while driving", having(navigation_of, publishes=False)),
    "humble": (
        "the bridge of Humble: a goal or call blocks its connection until done, no time limit",
        _humble,
    ),
    "mute-rejection": ("an old bridge: rejected goals get no reply", _mute_rejection),
    "unsourced": ("the bridge lacks the package nav2_msgs", wire.unsourced("nav2_msgs")),
    "volatile-pose": (
        f"its localisation not latched, sent every {wire.AGAIN:g} s, as by slam_toolbox",
        wire.volatile_pose,
    ),
    "never": ("services never reply and do nothing", wire.never),
} | {name: OF_ALL[name] for name in GENERIC}
