"""Poses and goals chosen on the map: opened where the kind takes them, sent after a question."""

import numpy as np
import pytest
from msgspec.structs import replace

from fleet_tui.features.set_up.poses import PoseRequests
from fleet_tui.model.events import CommandPathChanged, Event, GridReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED
from fleet_tui.model.kind import GOAL, POSE, SCAN, Kind
from fleet_tui.model.link import CommandPath
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.problem import Permissions
from fleet_tui.model.set_up.commands import SendGoal, SetPose
from fleet_tui.model.set_up.streams import Beams, Streamed
from fleet_tui.ui.controllers.comparison import ScanComparison
from fleet_tui.ui.view.map.floor_scene import floor_scene
from tests.support.desk import Desk, ready
from tests.support.fleets import F0, LINK, R0, T0, fleet, link_up, of_kinds, pose, queue, reduced, tick
from tests.support.map_pane import Pane

PLAIN = ready().robots["robot_0"].kind
KIND = replace(PLAIN, accepts=(*PLAIN.accepts, POSE, GOAL))


def placing(
    pane: Pane,
    kind: Kind = KIND,
    may: Permissions | None = None,
    *events: Event,
    state: FleetState | None = None,
) -> tuple[Desk, PoseRequests]:
    desk = Desk(reduced(of_kinds(state or ready(), kind), *events), may)
    picture = pane.map.picture
    pane.map.show(floor_scene(desk.store.state, desk.navigation.selection))
    comparison = ScanComparison(desk.store, desk.backend, desk.notices)
    return desk, PoseRequests(desk.console(), pane.controls, picture, comparison)


async def test_a_pose_begins_at_the_robot_is_turned_asked_and_sent() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        stands = (queue(T0 + 1), pose(T0 + 1), pose(T0 + 9), tick(T0 + 9))
        desk, it = placing(pilot.app, KIND, None, *stands)
        it.pose()
        assert it.mode is not None and it.mode.cursor == (0.0, 0.0)
        it.turn(5)
        chosen = it.mode.pose
        it.send()
        assert desk.backend.submitted == [] and len(desk.answers) == 1
        desk.say_yes()
        assert desk.backend.submitted == [SetPose("robot_0", "floor_0", chosen)]
        assert it.mode is None


@pytest.mark.parametrize(
    ("x", "doubt"), [(0.0, ""), (-0.8, "Only 0 % of the scan fits here. Send it anyway?")]
)
async def test_the_question_names_a_doubtful_fit(x: float, doubt: str) -> None:
    cells = np.full((20, 40), FREE, np.uint8)
    cells[:, 15] = OCCUPIED
    wall = GridReceived(R0, F0, build_grid(MapFrame(0.1, 40, 20, Pose(0.0, -1.0)), cells))
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        stands = (queue(T0 + 1), pose(T0 + 1), pose(T0 + 9), tick(T0 + 9))
        desk, it = placing(pilot.app, KIND, None, wall, *stands)
        desk.backend.streams.watch(R0, SCAN)
        beams = Beams(np.array([[1.55, 0.0]] * 30, np.float32), 30, "laser", None, True)
        desk.backend.streams.put(R0, SCAN, Streamed(beams, T0 + 9, T0 + 9))
        it.pose()
        assert it.mode is not None
        it.mode.put(Pose(x, 0.0))
        it.send()
        assert ("of the scan fits" in desk.asked[-1]) == bool(doubt) and doubt in desk.asked[-1]


async def test_a_goal_is_asked_too() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        desk, it = placing(pilot.app)
        state = desk.store.state
        robot = state.robots["robot_0"]
        assert robot.orders.open
        it.goal()
        it.send()
        desk.say_yes()
        assert not any(isinstance(one, SendGoal) for one in desk.backend.submitted)
        assert "cancel or clear first" in desk.notices.text


@pytest.mark.parametrize(
    ("may", "kind", "said"),
    [
        (Permissions(read_only=True), KIND, "read-only"),
        (Permissions(armed=False), KIND, "not armed"),
        (Permissions(), replace(KIND, accepts=()), "no setting of the pose"),
    ],
)
async def test_it_says_why_not(may: Permissions, kind: Kind, said: str) -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        desk, it = placing(pilot.app, kind, may)
        it.pose()
        assert it.mode is None and said in desk.notices.text


async def test_escape_sends_nothing() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        desk, it = placing(pilot.app)
        it.goal()
        it.leave()
        it.send()
        assert it.mode is None and not desk.answers and not desk.backend.submitted


async def test_a_goal_on_a_floor_that_the_robot_has_left_is_not_sent() -> None:
    async with Pane().run_test(size=(100, 30)) as pilot:
        assert isinstance(pilot.app, Pane)
        alive = CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)
        there = (link_up(T0), alive, queue(T0), pose(T0), tick(T0))
        desk, it = placing(pilot.app, KIND, None, *there, state=fleet(1, 2))
        it.goal()
        it.send()
        assert len(desk.answers) == 1
        desk.store.apply(pose(T0 + 2, frame=F0.replace("0", "1")))
        desk.say_yes()
        assert not desk.backend.submitted
        assert desk.notices.text == "not sent: robot_0 is on floor_1, the goal on floor_0"
