"""Any event, for property tests."""

from hypothesis import strategies as st

from fleet_tui.model import events, navigation_events
from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, PlaceOrder, ResumeRobot, Stage
from fleet_tui.model.desk import events as desk_events
from fleet_tui.model.desk.desk import Colleague, CommandElsewhere
from fleet_tui.model.fleets import events as fleet_events
from fleet_tui.model.fleets.facility import DOOR, LANES, LIFT, Facility
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.navigation import Goal, Progress, Servers
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.model.order import Order, OrderQueue, OrderState, Stop
from fleet_tui.model.set_up.commands import Localise, SendGoal, SendGraph, SetMapping, SetPose, Settle
from fleet_tui.model.vehicles import events as vehicle_events
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleConnection, VehicleError
from tests.support.fleets import LINK, T0

AT = st.floats(T0, T0 + 1e4)


NUMBERS = st.floats(allow_nan=False, allow_infinity=False)


NUMBERED = st.integers(-(2**31), 2**31 - 1) | st.integers(-1, 4)


IDS = st.text(max_size=3) | NUMBERED.map(str)


PLACES = st.builds(Pose, NUMBERS, NUMBERS)


STOPS = st.lists(st.builds(Stop, IDS) | st.builds(Stop, pose=PLACES), max_size=4).map(tuple)


WHAT = st.sampled_from(["cancel", "clear", "order"])


ROBOTS = st.sampled_from(["robot_0", "robot_1", "stranger"])


FLOORS = st.sampled_from(["floor_0", "floor_1", "attic"])


FRAME = MapFrame(0.05, 1, 1)


STATES = st.none() | st.sampled_from(OrderState)


ORDERS = st.builds(Order, IDS, STOPS, STATES, st.text(max_size=3), NUMBERED)


QUEUES = st.builds(OrderQueue, NUMBERED, IDS, st.lists(ORDERS, max_size=4).map(tuple), NUMBERED)


VERTICES = st.lists(st.builds(Vertex, IDS, NUMBERS, NUMBERS), max_size=3).map(tuple)


EDGES = st.lists(st.builds(Edge, IDS, IDS, IDS), max_size=3).map(tuple)


LABELS = st.lists(st.tuples(IDS, st.text(max_size=3)), max_size=3).map(tuple)


COMMANDS = st.one_of(
    st.builds(PlaceOrder, ROBOTS, STOPS.filter(len), st.booleans()),
    st.builds(CancelOrder, ROBOTS, IDS),
    *(st.builds(kind, ROBOTS) for kind in (ClearOrders, PauseRobot, ResumeRobot, Localise, Settle)),
    *(st.builds(kind, ROBOTS, FLOORS, PLACES) for kind in (SetPose, SendGoal)),
    st.builds(SetMapping, ROBOTS, st.booleans()),
    st.builds(SendGraph, ROBOTS, FLOORS, VERTICES, EDGES, st.booleans(), LABELS),
)


CONNECTIONS = st.sampled_from(["ONLINE", "OFFLINE", "CONNECTIONBROKEN", "any"])


NODES = st.builds(
    RouteGraph,
    st.dictionaries(IDS, st.builds(Vertex, IDS, NUMBERS, NUMBERS), max_size=3),
    EDGES,
    st.booleans(),
)


VEHICLES = st.builds(
    Vehicle,
    st.just("uagv/v2/a/b/\0"),
    st.sampled_from(["1.1.0", "2.0.0", "3.0.0"]),
    mode=st.sampled_from(["", "AUTOMATIC", "MANUAL"]),
    localised=st.none() | st.booleans(),
    e_stop=st.sampled_from(["", "MANUAL"]),
    field_violation=st.none() | st.booleans(),
    last_node=IDS,
    nodes_left=st.lists(IDS, max_size=3).map(tuple),
    waits=st.booleans(),
    errors=st.lists(st.builds(VehicleError, IDS, st.sampled_from(["FATAL", "WARNING"])), max_size=2).map(
        tuple
    ),
)


COMMAND_IDS = st.integers(1, 5)


GOALS = st.builds(
    Goal, IDS, IDS, st.just("navigate_to_pose"), STATES, st.text(max_size=3), st.none() | NUMBERS
)


FEW = st.none() | NUMBERS


TASKS = st.builds(
    Goal,
    IDS,
    IDS,
    st.just("task"),
    STATES,
    label=st.text(max_size=3),
    requester=IDS,
    tokens=st.lists(IDS, max_size=2).map(tuple),
)


ISSUES = st.lists(st.text(max_size=9), max_size=2).map(tuple)


CLOSED = st.tuples(FLOORS, IDS, IDS)


FACTS: dict[type, st.SearchStrategy[events.Event]] = {
    navigation_events.OdometryReported: st.builds(
        navigation_events.OdometryReported, ROBOTS, AT, PLACES, FEW, st.booleans()
    ),
    navigation_events.OriginReported: st.builds(
        navigation_events.OriginReported, ROBOTS, AT, PLACES, st.text(max_size=4), st.booleans()
    ),
    navigation_events.LocalisationReported: st.builds(
        navigation_events.LocalisationReported,
        *(ROBOTS, AT, PLACES, st.text(max_size=4), FEW, FEW, st.booleans()),
    ),
    navigation_events.BlockedReported: st.builds(
        navigation_events.BlockedReported,
        ROBOTS,
        AT,
        st.sampled_from(["", "stop", "limit"]),
        st.text(max_size=4),
    ),
    navigation_events.ProgressReported: st.builds(
        navigation_events.ProgressReported,
        ROBOTS,
        AT,
        st.builds(Progress, IDS, FEW, FEW, FEW, st.none(), NUMBERED),
    ),
    navigation_events.GoalsReported: st.builds(
        navigation_events.GoalsReported,
        ROBOTS,
        AT,
        st.sampled_from(["follow_waypoints", "navigate_to_pose"]),
        st.lists(GOALS, max_size=4).map(tuple),
    ),
    navigation_events.MotionStopped: st.builds(
        navigation_events.MotionStopped, ROBOTS, AT, st.sampled_from(["spin", "backup"])
    ),
    navigation_events.ServersReported: st.builds(
        navigation_events.ServersReported,
        ROBOTS,
        AT,
        st.none()
        | st.builds(
            Servers, st.booleans(), st.sampled_from(["", "planner_server"]), st.sampled_from(["", "down"])
        ),
    ),
    navigation_events.GoalsUnknown: st.builds(
        navigation_events.GoalsUnknown, ROBOTS, AT, st.lists(GOALS.map(lambda goal: goal.uuid)).map(tuple)
    ),
    navigation_events.PlanReported: st.builds(navigation_events.PlanReported, ROBOTS, AT, PLACES),
    navigation_events.TargetReported: st.builds(navigation_events.TargetReported, ROBOTS, AT, PLACES),
    navigation_events.ErrorReported: st.builds(
        navigation_events.ErrorReported, ROBOTS, AT, st.text(max_size=4), st.booleans(), FEW
    ),
    navigation_events.Alive: st.builds(navigation_events.Alive, ROBOTS, AT),
    navigation_events.Unmeasured: st.builds(navigation_events.Unmeasured, ROBOTS, AT, st.text(max_size=4)),
    navigation_events.ModeReported: st.builds(
        navigation_events.ModeReported, ROBOTS, AT, st.sampled_from(["mapping", "idle"])
    ),
    navigation_events.FloorReported: st.builds(navigation_events.FloorReported, ROBOTS, AT, FLOORS),
    navigation_events.QueueHeld: st.builds(navigation_events.QueueHeld, ROBOTS, st.text(max_size=4)),
    navigation_events.OrderMoved: st.builds(
        navigation_events.OrderMoved, ROBOTS, *2 * [st.sampled_from(["k1", "k2", ""])], AT
    ),
    navigation_events.GoalAnswered: st.builds(
        navigation_events.GoalAnswered,
        COMMAND_IDS,
        st.sampled_from([Stage.DONE, Stage.FAILED]),
        AT,
        st.text(max_size=4),
    ),
    fleet_events.MemberReported: st.builds(
        fleet_events.MemberReported,
        *(ROBOTS, AT, PLACES, FLOORS, FEW, st.none() | st.floats(0, 101), st.text(max_size=4), IDS),
    ),
    fleet_events.StatusReported: st.builds(
        fleet_events.StatusReported,
        *(ROBOTS, AT, st.sampled_from(["idle", "offline"]), IDS, ISSUES, st.none() | PLACES, FLOORS),
        st.none() | st.floats(0, 101),
    ),
    fleet_events.RequestAnswered: st.builds(
        fleet_events.RequestAnswered,
        *(IDS, AT, st.sampled_from([Stage.ACCEPTED, Stage.REFUSED]), st.text(max_size=4), IDS),
    ),
    fleet_events.DispatchFailed: st.builds(fleet_events.DispatchFailed, IDS, AT, st.text(max_size=4)),
    fleet_events.FacilityReported: st.builds(
        fleet_events.FacilityReported,
        ROBOTS,
        AT,
        st.builds(
            Facility,
            *(st.sampled_from((LIFT, DOOR, LANES)), IDS, AT, IDS, IDS, ROBOTS),
            st.lists(IDS, max_size=2).map(tuple),
        ),
    ),
    fleet_events.TaskReported: st.builds(fleet_events.TaskReported, ROBOTS, AT, TASKS, FEW),
    events.PoseReported: st.builds(
        events.PoseReported,
        ROBOTS,
        AT,
        st.builds(Pose, NUMBERS, NUMBERS, NUMBERS),
        FLOORS | st.text(max_size=4),
        st.none() | NUMBERS,
    ),
    events.BatteryReported: st.builds(events.BatteryReported, ROBOTS, AT, NUMBERS),
    events.CargoReported: st.builds(events.CargoReported, ROBOTS, AT, st.booleans()),
    events.ObstacleReported: st.builds(events.ObstacleReported, ROBOTS, AT, NUMBERS),
    events.QueueReported: st.builds(events.QueueReported, ROBOTS, AT, QUEUES),
    events.PausedReported: st.builds(events.PausedReported, ROBOTS, AT, st.booleans()),
    events.FrameReceived: st.builds(events.FrameReceived, ROBOTS, FLOORS, st.just(FRAME)),
    events.GraphReceived: st.builds(
        events.GraphReceived, ROBOTS, FLOORS, st.just(RouteGraph()), st.integers(0, 3), st.text(max_size=9)
    ),
    events.LabelsReceived: st.builds(
        events.LabelsReceived, ROBOTS, FLOORS, st.dictionaries(IDS, st.text(max_size=9), max_size=3)
    ),
    events.GridReceived: st.builds(events.GridReceived, ROBOTS, FLOORS, st.just(grid_from_ros(FRAME, b"\0"))),
    events.MessageRejected: st.builds(events.MessageRejected, ROBOTS, st.text(max_size=9)),
    events.FrameRejected: st.builds(events.FrameRejected, st.just(LINK), st.text(max_size=9)),
    events.FloorMapLoaded: st.builds(
        events.FloorMapLoaded, st.just("floor_0"), st.none(), st.text(max_size=9), st.booleans()
    ),
    events.FloorGraphLoaded: st.builds(
        events.FloorGraphLoaded,
        st.sampled_from(["floor_0", "floor_1"]),
        st.none() | st.just(RouteGraph()),
        st.dictionaries(IDS, st.text(max_size=9), max_size=3),
        st.text(max_size=9),
    ),
    events.LinkChanged: st.builds(
        events.LinkChanged, st.just(LINK), AT, st.sampled_from(Phase), st.text(max_size=9), st.none() | AT
    ),
    events.MessageArrived: st.builds(events.MessageArrived, st.just(LINK), AT),
    events.TopicsDropped: st.builds(
        events.TopicsDropped, st.just(LINK), st.lists(st.sampled_from(["robot_0", "robot_1"])).map(tuple)
    ),
    events.TopicNotAllowed: st.builds(
        events.TopicNotAllowed, st.just(LINK), st.text(max_size=9), st.just(("robot_0",))
    ),
    events.CallNotAllowed: st.builds(
        events.CallNotAllowed, st.just(LINK), st.text(max_size=9), st.just("services_glob")
    ),
    events.MessagesUnsourced: st.builds(events.MessagesUnsourced, st.just(LINK), st.text(max_size=9)),
    events.BridgeAnswered: st.builds(
        events.BridgeAnswered, st.just(LINK), AT, st.floats(0.0, 60.0), st.none() | NUMBERS
    ),
    events.SubscriptionsAdvanced: st.builds(
        events.SubscriptionsAdvanced, st.just(LINK), AT, st.integers(0, 900), st.integers(900, 901)
    ),
    events.CommandPathChanged: st.builds(
        events.CommandPathChanged, st.just(LINK), st.sampled_from(CommandPath), st.text(max_size=9)
    ),
    events.CommandIssued: st.builds(events.CommandIssued, COMMAND_IDS, COMMANDS, AT, AT),
    events.CommandAdvanced: st.builds(
        events.CommandAdvanced, COMMAND_IDS, st.sampled_from(Stage), AT, st.text(max_size=9), IDS
    ),
    desk_events.AlarmAcknowledged: st.builds(
        desk_events.AlarmAcknowledged,
        st.sampled_from(["", "robot_0", LINK]),
        st.sampled_from(["", "offline", "link"]),
    ),
    desk_events.AlarmShelved: st.builds(
        desk_events.AlarmShelved, ROBOTS, st.sampled_from(["offline", "battery"]), AT
    ),
    desk_events.AlarmUnshelved: st.builds(
        desk_events.AlarmUnshelved, ROBOTS, st.sampled_from(["offline", "battery"])
    ),
    desk_events.DeskJoined: st.builds(desk_events.DeskJoined, st.text(max_size=3)),
    desk_events.ColleaguesSeen: st.builds(
        desk_events.ColleaguesSeen,
        st.lists(
            st.builds(Colleague, IDS, IDS, IDS, ROBOTS, st.lists(ROBOTS, max_size=2).map(tuple)), max_size=2
        ).map(tuple),
    ),
    desk_events.RobotClaimed: st.builds(desk_events.RobotClaimed, ROBOTS),
    desk_events.RobotReleased: st.builds(desk_events.RobotReleased, ROBOTS),
    desk_events.EdgeClosed: st.builds(desk_events.EdgeClosed, CLOSED, AT, st.text(max_size=3)),
    desk_events.EdgeOpened: st.builds(desk_events.EdgeOpened, CLOSED, st.text(max_size=3)),
    desk_events.CommandedElsewhere: st.builds(
        desk_events.CommandedElsewhere,
        st.builds(CommandElsewhere, IDS, ROBOTS, IDS, IDS, IDS, AT, st.sampled_from(Stage), WHAT),
    ),
    vehicle_events.VehicleReported: st.builds(vehicle_events.VehicleReported, ROBOTS, AT, VEHICLES),
    vehicle_events.ConnectionReported: st.builds(
        vehicle_events.ConnectionReported,
        ROBOTS,
        AT,
        st.builds(VehicleConnection, CONNECTIONS, st.just("uagv/v2/a/b/\0"), st.sampled_from(["", "2.0.0"])),
        st.booleans(),
    ),
    vehicle_events.NodesReported: st.builds(vehicle_events.NodesReported, ROBOTS, AT, FLOORS, NODES),
    vehicle_events.FactsheetReported: st.builds(
        vehicle_events.FactsheetReported, ROBOTS, AT, st.dictionaries(IDS, st.text(max_size=9), max_size=3)
    ),
    vehicle_events.MessageKept: st.builds(vehicle_events.MessageKept, ROBOTS, AT, st.text(max_size=9)),
    vehicle_events.MasterSeen: st.builds(vehicle_events.MasterSeen, ROBOTS, AT, st.text(max_size=9)),
    events.TimePassed: st.builds(events.TimePassed, AT, AT),
}


ANY = st.lists(st.one_of(*FACTS.values()), max_size=40)
