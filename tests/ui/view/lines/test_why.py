"""The panel's text: since when, what, how likely, how old, and which key helps."""

import re

from fleet_tui.keys.keymap import keymap
from fleet_tui.model.events import CargoReported, PoseReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import Kind
from fleet_tui.ui.view.lines.why import SHOWN, UNBROKEN, why_lines
from tests.support.fleets import (
    R0,
    T0,
    battery,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.kinds import FULL, KEYS, received
from tests.support.planted_fleet import Planted
from tests.support.situations import driving

REMAPPED, _ = keymap({"resume": "f5", "clear": "ctrl+x"})


def text(planted: Planted, keys: dict[str, tuple[str, ...]] = KEYS) -> str:
    return "\n".join(why_lines(planted.state, planted.robot, keys))


def test_without_a_link_the_key_of_diagnostics_is_named() -> None:
    state = reduced(fleet(1), link_up(T0), pose(T0), link_lost(T0 + 1), tick(T0 + 9))
    assert "d\u00a0" in "\n".join(why_lines(state, state.robots[R0], KEYS))


PAUSED_AND_BLOCKED = """\
No movement for 6 s. At Base.

▶ 1. paused (elsewhere)  (certain)
    not sent by this console, reported\u00a00.4\u00a0s\u00a0ago
    r\u00a0resume

  2. obstacle 5.7 s  (certain)
    obstacle contact: clear the path at the robot, reported\u00a00.4\u00a0s\u00a0ago
    c\u00a0centre"""


def test_a_robot_that_moves_tells_its_alarms_all_the_same() -> None:
    state = reduced(received(FULL), battery(T0, 5.0), pose(T0 + 0.3, x=2.0), tick(T0 + 0.4))
    lines = why_lines(state, state.robots[R0], KEYS)
    assert lines[0].startswith("robot_0 is driving") and "▲ battery 5 %" in lines
    assert lines[-2].strip() == "Send it to a charger"
    assert lines[-1].strip() == "C\u00a0charge   o\u00a0order"


def test_paused_and_blocked() -> None:
    assert text(Planted("paused:robot_0,obstacle:robot_0").run(6)) == PAUSED_AND_BLOCKED


def test_in_brief_only_the_first_reason_has_its_evidence() -> None:
    planted = Planted("paused:robot_0,obstacle:robot_0").run(6)
    brief = "\n".join(why_lines(planted.state, planted.robot, KEYS, is_brief=True))
    assert "not sent by this console" in brief and "2. obstacle" in brief
    assert "obstacle contact" not in brief and brief.count("reported\u00a00.4") == 1


def test_a_robot_that_is_gone() -> None:
    planted = Planted().run(3)
    planted.plant("silent:robot_0")
    assert (
        text(planted.run(20))
        == """\
Last seen at Base.

▶ 1. offline 20 s  (certain)
    link up, no messages
    Check the robot: power, Wi-Fi, its software
    d\u00a0Open diagnostics"""
    )


def test_remapped_keys_are_shown() -> None:
    lines = text(Planted("paused:robot_0").run(3), REMAPPED)
    assert "    F5\u00a0resume" in lines


def test_what_the_wire_says_is_only_text_and_there_is_an_end_to_it() -> None:
    state = reduced(
        fleet(2),
        link_up(T0),
        graph(1, 2, 3),
        labels({1: "\x1b[2JBase", 3: "[red]x"}),
        pose(T0),
        PoseReported("robot_1", T0, Pose(1.0, 0.0), "floor_0", None),
        CargoReported(R0, T0, False),
        queue(T0, (1, 1, 3, "W"), current=1),
        tick(T0 + 3),
    )
    lines = why_lines(state, state.robots[R0], KEYS)
    assert "▶ 1. loading at ␛[2JBase  (likely)" in lines
    assert "    for order 1, ␛[2JBase -> [red]x" in lines
    assert all(line.replace(UNBROKEN, " ").isprintable() for line in lines)
    assert sum(line.startswith(("▶", "  2", "  3", "  4", "  5")) for line in lines) <= SHOWN


def test_why_offers_no_key_that_the_kind_does_not_accept() -> None:
    orders = queue(T0 + 9)
    for kind, is_offered in ((FULL, True), (Kind("x", FULL.reports), False)):
        state = reduced(received(kind), orders, pose(T0 + 9), tick(T0 + 9))
        lines = why_lines(state, state.robots[R0], KEYS)
        assert any("no orders" in line for line in lines)
        assert any("o\u00a0order" in line for line in lines) is is_offered


def test_without_a_cause_it_says_once_how_long_and_what_to_do() -> None:
    said = text(driving(then="stuck:robot_0").run(60))
    assert "▶ 1. stuck 60 s: cause unknown\n" in said and " for " not in said
    assert "    Go and check its path, wheels, emergency stop and manual mode\n" in said
    assert said.index("x\u00a0cancel") < said.index("X\u00a0clear")


def test_one_event_has_one_age() -> None:
    """The contact began before the robot stood, or after: two ages would be two events."""
    planted = driving(then="obstacle:robot_0").run(20)
    text = "\n".join(why_lines(planted.state, planted.robot, KEYS))
    assert len(re.findall(r"\d+ s\b(?! ago)", text)) == 1, text
    assert text.startswith("Not moving.") and "▶ 1. obstacle " in text
