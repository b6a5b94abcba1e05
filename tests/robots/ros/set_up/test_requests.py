"""Set-up commands as messages: what a robot gets, and the key that is missing where it gets none."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.model.geometry import Pose, yaw_of_quaternion
from fleet_tui.model.set_up.commands import CancelGoal, Localise, SendGoal, SetMapping, SetPose, Settle
from fleet_tui.robots.adapter import Publication, ServiceCall, Site
from fleet_tui.robots.oh_ressources.adapter import OhRessources
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS
from fleet_tui.robots.ros.set_up.requests import solid
from fleet_tui.text.errors import CommandError
from tests.support.fleets import R0, fleet
from tests.support.nav2_adapter import adapter, robot

POSE = Pose(1.5, -2.0, 0.5)
SITE = Site(frames={"floor_0": "map_0"})
NAMED = Profile(
    topics={"initial_pose": "/{robot}/initialpose", "goal": "/{robot}/goal", "mode": "/{robot}/mode"},
    services={"mapping_on": "/{robot}/mapping", "mapping_off": "/{robot}/mapping"},
)


def test_a_pose_goes_out_as_rviz_sends_it() -> None:
    (sent,) = adapter().outgoing(SetPose("tb2", "hall", POSE), 1, replace(robot(), frame_id="map"))
    assert isinstance(sent, Publication)
    assert (sent.address, sent.type) == ("/tb2/initialpose", "geometry_msgs/PoseWithCovarianceStamped")
    message = json.loads(json.dumps(sent.message))
    assert message["header"] == {"frame_id": "map"}
    covariance = message["pose"]["covariance"]
    assert {n: round(value, 4) for n, value in enumerate(covariance) if value} == {
        0: 0.25,
        7: 0.25,
        35: 0.0685,
    }
    assert len(covariance) == 36 and message["pose"]["pose"]["position"] == {"x": 1.5, "y": -2.0, "z": 0.0}


@given(st.floats(-1e9, 1e9), st.floats(-1e9, 1e9), st.floats(allow_nan=False, allow_infinity=False))
def test_a_quaternion_has_unit_length(x: float, y: float, yaw: float) -> None:
    turn = solid(Pose(x, y, yaw))["orientation"]
    assert isinstance(turn, dict)
    assert math.isclose(sum(value * value for value in turn.values()), 1.0, abs_tol=1e-12)
    assert abs(math.remainder(yaw_of_quaternion(**turn) - math.remainder(yaw, math.tau), math.tau)) < 1e-6


@pytest.mark.parametrize("pose", [Pose(math.nan, 0.0), Pose(0.0, math.inf), Pose(0.0, 0.0, math.nan)])
def test_what_json_cannot_say_is_not_sent(pose: Pose) -> None:
    with pytest.raises(CommandError, match="not finite"):
        solid(pose)


def test_the_frame_is_the_floors_or_the_profiles() -> None:
    source = fleet().robots[R0]

    def frame(profile: Profile, site: Site = SITE) -> object:
        (sent,) = OhRessources(profile, site).outgoing(SetPose(R0, "floor_0", POSE), 1, source)
        assert isinstance(sent, Publication)
        header = sent.message["header"]
        assert isinstance(header, dict)
        return header["frame_id"]

    assert frame(NAMED) == "map_0"
    assert frame(NAMED, Site()) == "floor_0"
    chosen = replace(NAMED, pose_frame="{robot}/{floor}")
    assert frame(chosen) == f"{R0}/floor_0"


def test_the_source_has_no_name_and_says_which_key_is_empty() -> None:
    bare, named = OhRessources(Profile(), SITE).kind, OhRessources(NAMED, SITE).kind
    assert {"pose", "goal", "mapping", "scan", "path"} <= bare.unset.keys()
    assert bare.lack("pose") == "profile.topics.initial_pose is empty: no setting of the pose"
    assert bare.lack("mapping") == "profile.services.mapping_on is empty: no switch of the mapping mode"
    assert {"pose", "goal", "mapping"} <= set(named.accepts) and "mode" in named.reports
    with pytest.raises(CommandError, match="initial_pose is empty"):
        OhRessources(Profile(), SITE).outgoing(SetPose(R0, "floor_0", POSE), 1, fleet().robots[R0])


def test_a_goal_is_cancelled_by_the_id_of_all_since_it_has_none_here() -> None:
    source, profile = fleet().robots[R0], Profile(topics={"goal_cancel": "/{robot}/move_base/cancel"})
    (sent,) = OhRessources(profile, SITE).outgoing(CancelGoal(R0), 1, source)
    assert isinstance(sent, Publication)
    assert (sent.address, sent.type) == (f"/{R0}/move_base/cancel", "actionlib_msgs/GoalID")
    assert sent.message == {"stamp": {"secs": 0, "nsecs": 0}, "id": ""}
    bare = OhRessources(Profile(), SITE)
    assert bare.kind.lack("goal cancel") == "profile.topics.goal_cancel is empty: no cancellation of goals"
    with pytest.raises(CommandError, match="goal_cancel is empty"):
        bare.outgoing(CancelGoal(R0), 1, source)
    assert adapter().kind.lack("goal cancel") == "this kind has no cancellation of goals"


def test_a_goal_beside_orders_is_the_sources_alone() -> None:
    (sent,) = OhRessources(NAMED, SITE).outgoing(SendGoal(R0, "floor_0", POSE), 1, fleet().robots[R0])
    assert isinstance(sent, Publication)
    assert (sent.address, sent.type) == (f"/{R0}/goal", "geometry_msgs/PoseStamped")
    assert "goal" not in adapter().kind.accepts


@pytest.mark.parametrize("kind", ["nav2", "move_base"])
def test_navigation_stacks_have_the_usual_names(kind: str) -> None:
    it = KINDS[kind].adapter(Profile(kind=kind), Site())
    assert {"pose", "localise", "settle", "mapping"} <= set(it.kind.accepts)
    assert it.kind.streams == ("scan", "path", "camera")
    calls = [it.outgoing(command, 1, robot())[0] for command in (Localise("tb2"), Settle("tb2"))]
    assert all(isinstance(call, ServiceCall) and call.args == {} for call in calls)
    (on,), (off,) = (it.outgoing(SetMapping("tb2", wanted), 1, robot()) for wanted in (True, False))
    assert isinstance(on, ServiceCall) and isinstance(off, ServiceCall)
    assert (on.args, off.args) == ({"data": False}, {"data": True})


def test_the_fields_of_a_request_can_be_named() -> None:
    it = adapter(requests={"mapping_on": {"name": "{robot}_slam", "n": 3}})
    (call,) = it.outgoing(SetMapping("tb2", True), 1, robot())
    assert isinstance(call, ServiceCall) and call.args == {"name": "tb2_slam", "n": 3}
