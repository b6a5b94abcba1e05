"""Tasks name their keys as configured, and only those with a use."""

from fleet_tui.keys import BY_ID
from fleet_tui.keys.keymap import keymap
from fleet_tui.ui.view.help.pages import TASKS, tasks
from fleet_tui.ui.view.help.section import HelpSection
from tests.support.fleets import text_of
from tests.support.kinds import KEYS


def marks(sections: list[HelpSection]) -> dict[str, list[str]]:
    return {section.title: [text_of(row.mark) for row in section.rows] for section in sections}


def test_every_key_of_a_task_exists() -> None:
    assert {id_ for steps in TASKS.values() for ids, _ in steps for id_ in ids} <= set(BY_ID)


def test_keys_are_shown_as_they_are_set() -> None:
    chosen, _ = keymap({"order": "ctrl+o", "pause": "f5,u", "robot_1": "f2"})
    found = marks(tasks(chosen, ()))
    assert found["Send an order"][0] == "Ctrl-O" and found["Stop a robot"][0] == "F5"
    assert ". , F2 2 3 4 5 6 7 8 9" in found["Choose a robot or a floor"]
    usual = marks(tasks(KEYS, ()))
    assert ". , 1..9" in usual["Choose a robot or a floor"] and "arrows" in usual["Look around on the map"]
    assert usual["Look back in time"] == ["L H", ":"]


def test_steps_without_a_key_of_use_are_left_out() -> None:
    found = marks(tasks(KEYS, {"order", "pause_all", "why"}))
    assert "Send an order" not in found, "the map's cursor orders nothing then"
    assert "F12" in found["Stop a robot"] and "w" not in found["See what is wrong"]


def test_the_way_back_from_pause_all_is_named_where_robots_can_resume() -> None:
    assert "p" in marks(tasks(KEYS, set()))["Stop a robot"]
    assert "r R" in marks(tasks(KEYS, set()))["Stop a robot"]
    assert "r R" not in marks(tasks(KEYS, {"resume", "resume_all"}))["Stop a robot"]


def test_keys_without_altgr_are_named_where_they_work() -> None:
    in_recording = {"next_robot_plain", "previous_robot_plain", "next_floor_plain", "previous_floor_plain"}
    live, recording = (
        marks(tasks(KEYS, hidden))["Choose a robot or a floor"] for hidden in (set(), in_recording)
    )
    assert live == [". , 1..9", "!", "> <", ":"]
    assert recording == ["] [ 1..9", "!", "} {", ":"]
