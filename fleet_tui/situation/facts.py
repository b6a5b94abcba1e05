"""The table of facts: one row for each kind, which alarm, reason, row and status read."""

from fleet_tui.situation.fact import AlarmClass, FactKind

NO_LINK = FactKind(
    "link",
    "no link",
    "link restored",
    AlarmClass(
        "high",
        "no connection to a bridge or broker",
        "its robots can be neither seen nor commanded",
        "Start the bridge or broker, mend network or settings; `fleet-tui doctor` names the step that fails",
        1,
    ),
    keys=("diagnostics",),
    page="link",
)
BRIDGE_HANGS = NO_LINK._replace(
    # With that parameter it stops answering at the second subscription.
    remedy="Restart rosbridge, or repair the network; on ROS 2 start it without use_events_executor",
)
COMMANDS_DEAD = FactKind(
    "commands",
    "commands dead",
    "command path restored",
    AlarmClass(
        "high",
        "telemetry arrives, but commands would not get through, to the robots named or to all",
        "no order and no pause reaches the robots of the link, or those named",
        "Restart the robots' nodes or the ROS master; pause a robot by its own controls",
        1,
    ),
    keys=("diagnostics",),
    page="link",
)
HALF_DEAD = COMMANDS_DEAD._replace(
    word="rosbridge half dead",
    remedy="Restart rosbridge: nothing of its robots arrives, and they may drive on",
)
CALLS_HANG = COMMANDS_DEAD._replace(
    remedy="Restart rosbridge, on ROS 2 without use_events_executor; until then pause a robot by its own"
    " controls",
)
COMMANDS_UNTRIED = FactKind(
    "commands",
    "commands not tried yet",
    remedy="Start rosapi; after a restart of the ROS master restart rosbridge and the robots' nodes, too",
    keys=COMMANDS_DEAD.keys,
    page="link",
)
LATE_LINK = FactKind(
    "late",
    "bridge overloaded",
    "messages on time",
    AlarmClass(
        "medium",
        "a bridge takes at least a second to answer, and its messages wait as long; high once its robots are"
        " silent, or commands get no reply",
        "the data shown for its robots is old",
        "Stop its other clients, publish less often on the robots, or add a bridge: [links] in the config",
        10,
    ),
    keys=("diagnostics",),
)
LOST_SUBSCRIPTIONS = FactKind(
    "messages",
    "rosbridge lost its subscriptions",
    "topics arrive again",
    AlarmClass(
        "high",
        "rosbridge runs without the robots' message package, or lost its own subscriptions, as by a restart"
        " of the ROS master",
        "these robots' messages cannot be read, or do not arrive",
        "Restart rosbridge; of a lacking package source the robots' workspace before",
        10,
    ),
    remedy="Restart rosbridge: its ROS master was restarted, and its robots may be well",
    keys=("diagnostics",),
    page="link",
)
UNSOURCED = LOST_SUBSCRIPTIONS._replace(
    word="rosbridge lacks a package", over="message types available", remedy=""
)
NOT_ALLOWED = LOST_SUBSCRIPTIONS._replace(
    word="not allowed by the bridge",
    remedy="Add these names to that list of rosbridge (topics_glob, services_glob, actions_glob)"
    ", and restart it",
)
HEARTBEAT_NOT_ALLOWED = COMMANDS_DEAD._replace(
    remedy=NOT_ALLOWED.action,
)
BEHIND = FactKind(
    "behind",
    "this console is behind",
    "this console has caught up",
    AlarmClass(
        "medium",
        "this console is at least a second behind in reading messages",
        "all data shown is old",
        "Close other programs on this machine, or raise pose_ms and status_ms: [rates] in the config",
        10,
    ),
)
SILENT = FactKind(
    "offline",
    "offline",
    "back online",
    AlarmClass(
        "medium",
        "no message for longer than `offline_after` and its bridge's lateness together",
        "it may drive on unseen, and takes no commands",
        "Check the robot: power, Wi-Fi, its software",
        5,
    ),
    keys=("diagnostics",),
)
NEVER_SEEN = SILENT._replace(word="never seen")
AGE_UNKNOWN = SILENT._replace(word="age unknown")
OLD_STAMPS = FactKind(
    "localisation",
    "poses arrive late",
    "localisation recovered",
    AlarmClass(
        "medium",
        "the robot does not know where it is on its map, drives on without a localisation, reports without a"
        " pose, or for 20 s poses in walls, off the map or off its route graph",
        "it may drive into something, or stop; nobody sees where",
        "Pause it and set its pose; without a pose check its localisation",
        2,
    ),
    keys=("diagnostics",),
)
ADRIFT = OLD_STAMPS._replace(
    word="localisation silent",
    remedy="Pause it, and check its localisation: the node (amcl, slam_toolbox) and the laser",
    keys=("pause", *OLD_STAMPS.keys),
)
REPEATED_POSE = OLD_STAMPS._replace(word="poses repeat at rest")
UNDATED_POSE = OLD_STAMPS._replace(word="pose of unknown age")
NO_POSE = OLD_STAMPS._replace(
    word="no pose",
    remedy="Pause it, and check its localisation: its node, its laser, the topic's name",
)
UNCERTAIN = OLD_STAMPS._replace(word="localisation uncertain", keys=("pose", "centre"))
BAD_DATA = FactKind(
    "data",
    "bad data",
    "no new bad data",
    AlarmClass(
        "low",
        "a message could not be read in the last 10 s; medium if no message of a robot can be read",
        "a value of the robot, or of the link, is missing; with none, nobody sees where it is",
        "Open diagnostics (d), page Raw, and press b for the bad message",
        60,
    ),
    keys=("diagnostics",),
    page="raw",
)
OBSTACLE = FactKind(
    "obstacle",
    "blocked by an obstacle",
    "cleared: obstacle",
    AlarmClass(
        "high",
        "in contact with an obstacle for longer than `obstacle_after`",
        "the robot does not drive on; others queue behind it",
        "Clear the path at the robot",
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
        "Clear the path at the robot",
        5,
    ),
    keys=OBSTACLE.keys,
)
E_STOP = FactKind(
    "e-stop",
    "e-stop",
    "e-stop released",
    AlarmClass(
        "high",
        "an emergency stop of a vehicle is active",
        "the vehicle does not move; others queue behind it",
        "Go to the vehicle, check the area around it, then release it there",
        5,
    ),
    keys=OBSTACLE.keys,
)
FAULT = FactKind(
    "fault",
    "error",
    "no errors reported",
    AlarmClass(
        "high",
        "an error that a vehicle reports about itself: high if fatal or critical, medium if urgent, else low",
        "after a fatal one its order is not carried out",
        "Go to the vehicle if it stands",
        10,
    ),
    keys=OBSTACLE.keys,
)
UNLOCALISED = OLD_STAMPS._replace(
    word="not localised",
    over="localised again",
    remedy="Localise it at the vehicle: take it by hand to a place that it knows",
    keys=("pose", *OBSTACLE.keys),
)
DRIVES_ON = FactKind(
    "order",
    "order failed, still driving",
    "order failed",
    remedy="Pause it: that ends what still drives it",
    keys=("pause", "centre"),
)
INACTIVE = FactKind(
    "navigation",
    "Nav2 inactive",
    "navigation reports again",
    AlarmClass(
        "medium",
        "the robot reports, but its navigation gives no feedback on the current order any more, or is not"
        " active",
        "the order is not carried out, and cancelling it has no effect",
        "Restart the robot's navigation, then give the order again",
        5,
    ),
    keys=("pose", "diagnostics"),
    page="log",
)
NAVIGATION_SILENT = INACTIVE._replace(
    word="navigation silent",
    remedy="Restart the robot's navigation (move_base, bt_navigator), then give the order again",
    keys=("clear", "order"),
)
STOPPING = FactKind(
    "pause",
    "stopping",
    "pause ended",
    AlarmClass(
        "low",
        "paused for longer than `pause_after`; high if the robot still moves 3 s after the pause",
        "its orders wait; one that moves may hit somebody who trusts the pause",
        "Resume it, or find out who paused it",
        30,
    ),
    keys=("resume",),
)
STILL_MOVING = STOPPING._replace(
    word="still moving",
    over="stands now",
    remedy="Stop it by its own controls, or by its emergency stop",
    keys=("pause", "centre"),
)
DESPITE_PAUSE = STILL_MOVING._replace(
    word="driving despite pause",
    remedy="Pause it again, or find out who drives it",
)
BY_HAND = FactKind("mode", "mode", remedy="Switch it to automatic at the vehicle")
CLEARANCE = FactKind(
    "clearance", "waits for clearance", remedy="Look at the master control: it releases the next nodes"
)
MAP_DISABLED = FactKind(
    "map", "map is not enabled", remedy="Let the master control enable the map (enableMap)"
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
    BY_HAND,
    CLEARANCE,
    MAP_DISABLED,
)
