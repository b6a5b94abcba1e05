"""The conditions that a command without a screen waits for."""

import math

from fleet_tui.cli.session import missing
from fleet_tui.model.kind import Kind
from tests.support.fleets import R0, fleet, of_kinds
from tests.support.kinds import MUTE


def test_only_what_is_reported_again_and_again_is_missing() -> None:
    kind = Kind("some", ("pose", "battery", "queue", "labels"), silence={"queue": math.inf})
    state = of_kinds(fleet(), kind)
    assert missing(state.robots[R0]) == ["pose", "battery", "labels of floor_0"]
    assert missing(of_kinds(fleet(), MUTE).robots[R0]) == ["pose"]
