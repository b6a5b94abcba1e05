"""The mode of a robot: text or switch, in the robot's words or in ours."""

import json
from typing import Any

import msgspec
import pytest

from fleet_tui.model.navigation_events import ModeReported
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.set_up.reading import read_mode
from fleet_tui.text.errors import WireError
from tests.support.adapters import names_of

PROFILE = Profile(topics={"mode": "/{robot}/mode"}, modes={"SLAM": "mapping", "amcl": "navigation"})


def mode(profile: Profile, **msg: Any) -> str:
    event = read_mode(names_of(profile))("r", "", msgspec.Raw(json.dumps(msg).encode()), 5.0)
    assert isinstance(event, ModeReported)
    return event.mode


@pytest.mark.parametrize(
    ("said", "meant"),
    [("slam", "mapping"), ("AMCL", "navigation"), ("Mapping ", "mapping"), ("idle", "idle")],
)
def test_words_are_mapped(said: str, meant: str) -> None:
    assert mode(PROFILE, data=said) == meant


def test_a_switch_is_true_for_mapping() -> None:
    profile = msgspec.structs.replace(PROFILE, types={"mode": "std_msgs/msg/Bool"})
    assert [mode(profile, data=on) for on in (True, False)] == ["mapping", "navigation"]


def test_a_wrong_message_is_named() -> None:
    with pytest.raises(WireError):
        mode(PROFILE, data=3)
