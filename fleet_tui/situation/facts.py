"""The table of facts: one row for each kind, which alarm, reason, row and status read."""

from fleet_tui.situation.fact import AlarmClass, FactKind
from fleet_tui.text.language import EMPTY, N_, Message

NO_LINK = FactKind(
    "link",
    Message("no link"),
    Message("link restored"),
    AlarmClass(
        "high",
        "no connection to a bridge or broker",
        "its robots can be neither seen nor commanded",
        Message(
            "Start the bridge or broker, mend network or settings;"
            " `fleet-tui doctor` names the step that fails"
        ),
        1,
    ),
    keys=("diagnostics",),
    page="link",
)
BRIDGE_HANGS = NO_LINK._replace(
    # With that parameter it stops answering at the second subscription.
    remedy=Message("Restart rosbridge, or repair the network; on ROS 2 start it without use_events_executor")
)
COMMANDS_DEAD = FactKind(
    "commands",
    Message("commands dead"),
    Message("command path restored"),
    AlarmClass(
        "high",
        "telemetry arrives, but commands would not get through, to the robots named or to all",
        "no order and no pause reaches the robots of the link, or those named",
        Message("Restart the robots' nodes or the ROS master; pause a robot by its own controls"),
        1,
    ),
    keys=("diagnostics",),
    page="link",
)
HALF_DEAD = COMMANDS_DEAD._replace(
    word=Message("rosbridge half dead"),
    remedy=Message("Restart rosbridge: nothing of its robots arrives, and they may drive on"),
)
CALLS_HANG = COMMANDS_DEAD._replace(
    remedy=Message(
        "Restart rosbridge, on ROS 2 without use_events_executor;"
        " until then pause a robot by its own controls"
    )
)
COMMANDS_UNTRIED = FactKind(
    "commands",
    Message("commands not tried yet"),
    remedy=Message(
        "Start rosapi; after a restart of the ROS master restart rosbridge and the robots' nodes, too"
    ),
    keys=COMMANDS_DEAD.keys,
    page="link",
)
LATE_LINK = FactKind(
    N_("late"),
    Message("bridge overloaded"),
    Message("messages on time"),
    AlarmClass(
        "medium",
        "a bridge takes at least a second to answer, and its messages wait as long; high once its robots are"
        " silent, or commands get no reply",
        "the data shown for its robots is old",
        Message(
            "Stop its other clients, publish less often on the robots, or add a bridge: [links] in the config"
        ),
        10,
    ),
    keys=("diagnostics",),
)
LOST_SUBSCRIPTIONS = FactKind(
    "messages",
    Message("rosbridge lost its subscriptions"),
    Message("topics arrive again"),
    AlarmClass(
        "high",
        "rosbridge runs without the robots' message package, or lost its own subscriptions, as by a restart"
        " of the ROS master",
        "these robots' messages cannot be read, or do not arrive",
        Message("Restart rosbridge; if a package is missing, source the robots' workspace first"),
        10,
    ),
    remedy=Message("Restart rosbridge: its ROS master was restarted, and its robots may be well"),
    keys=("diagnostics",),
    page="link",
)
UNSOURCED = LOST_SUBSCRIPTIONS._replace(
    word=Message("rosbridge lacks a package"), over=Message("message types available"), remedy=EMPTY
)
NOT_ALLOWED = LOST_SUBSCRIPTIONS._replace(
    word=Message("not allowed by the bridge"),
    remedy=Message(
        "Add these names to that list of rosbridge (topics_glob, services_glob, actions_glob), and restart it"
    ),
)
HEARTBEAT_NOT_ALLOWED = COMMANDS_DEAD._replace(remedy=NOT_ALLOWED.action)
BEHIND = FactKind(
    N_("behind"),
    Message("this console is behind"),
    Message("this console has caught up"),
    AlarmClass(
        "medium",
        "this console is at least a second behind in reading messages",
        "all data shown is old",
        Message(
            "Close other programs on this machine, or raise pose_ms and status_ms: [rates] in the config"
        ),
        10,
    ),
)
SILENT = FactKind(
    "offline",
    Message("offline"),
    Message("back online"),
    AlarmClass(
        "medium",
        "no message for longer than `offline_after` and its bridge's lateness together",
        "it may drive on unseen, and takes no commands",
        Message("Check the robot: power, Wi-Fi, its software"),
        5,
    ),
    keys=("diagnostics",),
)
NEVER_SEEN = SILENT._replace(word=Message("never seen"))
AGE_UNKNOWN = SILENT._replace(word=Message("age unknown"))
OLD_STAMPS = FactKind(
    N_("localisation"),
    Message("poses arrive late"),
    Message("localisation recovered"),
    AlarmClass(
        "medium",
        "the robot does not know where it is on its map, drives on without a localisation, reports without a"
        " pose, or for 20 s poses in walls, off the map or off its route graph",
        "it may drive into something, or stop; nobody sees where",
        Message("Pause it and set its pose; without a pose check its localisation"),
        2,
    ),
    keys=("diagnostics",),
)
ADRIFT = OLD_STAMPS._replace(
    word=Message("localisation silent"),
    remedy=Message("Pause it, and check its localisation: the node (amcl, slam_toolbox) and the laser"),
    keys=("pause", *OLD_STAMPS.keys),
)
REPEATED_POSE = OLD_STAMPS._replace(word=Message("poses repeat at rest"))
UNDATED_POSE = OLD_STAMPS._replace(word=Message("pose of unknown age"))
NO_POSE = OLD_STAMPS._replace(
    word=Message("pose missing"),
    remedy=Message("Pause it, and check its localisation: its node, its laser, the topic's name"),
)
MISPLACED = OLD_STAMPS._replace(word=Message("pose doubtful"))
UNCERTAIN = OLD_STAMPS._replace(word=Message("localisation uncertain"), keys=("pose", "centre"))
BAD_DATA = FactKind(
    N_("data"),
    Message("bad data"),
    Message("no new bad data"),
    AlarmClass(
        "low",
        "a message could not be read in the last 10 s; medium if no message of a robot can be read",
        "a value of the robot, or of the link, is missing; with none, nobody sees where it is",
        Message("Open diagnostics (d), page Raw, and press b for the bad message"),
        60,
    ),
    keys=("diagnostics",),
    page="raw",
)
OBSTACLE = FactKind(
    "obstacle",
    Message("blocked by an obstacle"),
    Message("cleared: obstacle"),
    AlarmClass(
        "high",
        "in contact with an obstacle for longer than `obstacle_after`",
        "the robot does not drive on; others queue behind it",
        Message("Clear the path at the robot"),
        5,
    ),
    keys=("centre", "camera", "laser"),
)
STOP = FactKind(
    "blocked",
    OBSTACLE.word,
    OBSTACLE.over,
    AlarmClass(
        "high",
        "stopped by its collision monitor for longer than `obstacle_after`",
        "the robot does not drive on; its goal may be aborted",
        Message("Clear the path at the robot"),
        5,
    ),
    keys=OBSTACLE.keys,
)
E_STOP = FactKind(
    "e-stop",
    Message("e-stop"),
    Message("e-stop released"),
    AlarmClass(
        "high",
        "an emergency stop of a vehicle is active",
        "the vehicle does not move; others queue behind it",
        Message("Go to the vehicle, check the area around it, then release it there"),
        5,
    ),
    keys=OBSTACLE.keys,
)
FAULT = FactKind(
    N_("fault"),
    Message("error"),
    Message("no errors reported"),
    AlarmClass(
        "high",
        "an error that a vehicle reports about itself: high if fatal or critical, medium if urgent, else low",
        "after a fatal one its order is not carried out",
        Message("Go to the vehicle if it stands"),
        10,
    ),
    keys=OBSTACLE.keys,
)
UNLOCALISED = OLD_STAMPS._replace(
    word=Message("not localised"),
    over=Message("localised again"),
    remedy=Message("Localise it at the vehicle: take it by hand to a place that it knows"),
    keys=("pose", *OBSTACLE.keys),
)
DRIVES_ON = FactKind(
    "order",
    Message("order failed, still driving"),
    Message("order failed"),
    remedy=Message("Pause it: that stops whatever still drives it"),
    keys=("pause", "centre"),
)
INACTIVE = FactKind(
    N_("navigation"),
    Message("Nav2 inactive"),
    Message("navigation reports again"),
    AlarmClass(
        "medium",
        "the robot reports, but its navigation gives no feedback on the current order any more, or is not"
        " active",
        "the order is not carried out, and cancelling it has no effect",
        Message("Restart the robot's navigation, then give the order again"),
        5,
    ),
    keys=("pose", "diagnostics"),
    page="log",
)
NAVIGATION_SILENT = INACTIVE._replace(
    word=Message("navigation silent"),
    remedy=Message("Restart the robot's navigation (move_base, bt_navigator), then give the order again"),
    keys=("clear", "order"),
)
STOPPING = FactKind(
    "pause",
    Message("stopping"),
    Message("pause ended"),
    AlarmClass(
        "low",
        "paused for longer than `pause_after`; high if the robot still moves 3 s after the pause",
        "its orders wait; one that moves may hit somebody who trusts the pause",
        Message("Resume it, or find out who paused it"),
        30,
    ),
    keys=("resume",),
)
STILL_MOVING = STOPPING._replace(
    word=Message("still moving"),
    over=Message("stands now"),
    remedy=Message("Stop it by its own controls, or by its emergency stop"),
    keys=("pause", "centre"),
)
DESPITE_PAUSE = STILL_MOVING._replace(
    word=Message("driving despite pause"), remedy=Message("Pause it again, or find out who drives it")
)
STUCK = FactKind(
    N_("stuck"),
    Message("stuck"),
    Message("no longer stuck"),
    AlarmClass(
        "medium",
        "no movement for `stuck_after` in spite of an order, without an obstacle or a pause;"
        " a later one does not end it",
        "its order is not carried out",
        Message("Press w for the reasons; cancel the order or go to the robot"),
        10,
    ),
    keys=("centre", "cancel", "clear"),
    page="log",
)
BY_HAND = FactKind("mode", Message("mode"), remedy=Message("Switch it to automatic at the vehicle"))
CLEARANCE = FactKind(
    "clearance",
    Message("waits for clearance"),
    remedy=Message("Check the master control: it has to release the next nodes"),
)
MAP_DISABLED = FactKind(
    "map", Message("map is not enabled"), remedy=Message("Enable the map from the master control (enableMap)")
)
DEADLOCK = FactKind(
    N_("deadlock"),
    Message("deadlock"),
    Message("no longer wait for each other"),
    AlarmClass(
        "medium",
        "two robots with orders stand for 30 s, each on the other's next edge, by no pause or obstacle",
        "neither drives on; others queue behind them",
        Message("Send one of them away: cancel its order, order it elsewhere, then give its order again"),
        5,
    ),
    keys=("centre", "cancel", "order"),
)

FACTS = (
    NO_LINK,
    BRIDGE_HANGS,
    COMMANDS_DEAD,
    HALF_DEAD,
    CALLS_HANG,
    HEARTBEAT_NOT_ALLOWED,
    COMMANDS_UNTRIED,
    LATE_LINK,
    LOST_SUBSCRIPTIONS,
    UNSOURCED,
    NOT_ALLOWED,
    BEHIND,
    SILENT,
    NEVER_SEEN,
    AGE_UNKNOWN,
    OLD_STAMPS,
    ADRIFT,
    REPEATED_POSE,
    UNDATED_POSE,
    NO_POSE,
    MISPLACED,
    UNCERTAIN,
    BAD_DATA,
    OBSTACLE,
    STOP,
    E_STOP,
    FAULT,
    UNLOCALISED,
    DRIVES_ON,
    INACTIVE,
    NAVIGATION_SILENT,
    STOPPING,
    STILL_MOVING,
    DESPITE_PAUSE,
    STUCK,
    BY_HAND,
    CLEARANCE,
    MAP_DISABLED,
    DEADLOCK,
)
