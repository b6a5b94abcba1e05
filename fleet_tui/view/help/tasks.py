"""The first page of help: what people come for, each with its keys."""

from collections.abc import Collection, Mapping

from fleet_tui.keys import outdone
from fleet_tui.view.help.section import HelpSection, key_row

Step = tuple[tuple[str, ...], str]
"""The ids of the keys of a step, and their effect."""

ROBOTS = tuple(f"robot_{number}" for number in range(1, 10))
"""The ids of the keys that select a robot by its number."""
ROBOT_STEPS = ("next_robot_plain", "previous_robot_plain", "next_robot", "previous_robot")
FLOOR_STEPS = ("next_floor_plain", "previous_floor_plain", "next_floor", "previous_floor")
ORDERING = "Send an order"
TASKS: dict[str, tuple[Step, ...]] = {
    ORDERING: (
        (("order",), "Order form: From, Enter, To, Enter"),
        (("map_cursor", "pick"), "Map cursor; Enter orders from there"),
        (("goal",), "Send the robot to any point"),
        (("simple",), "Simple interface: large buttons"),
        (("palette",), "Typed: robot_0 Base > Store"),
    ),
    "Stop a robot": (
        (("pause",), "Pause the selected robot"),
        (("resume", "resume_all"), "Resume it; resume all (asks)"),
        (("pause_all", "pause_all_anywhere"), "Pause all robots (no safety device)"),
        (("cancel",), "Cancel order at the queue cursor"),
        (("clear",), "Clear all orders of the robot"),
    ),
    "Choose a robot or a floor": (
        ((*ROBOT_STEPS, *ROBOTS), "Next, previous robot; by number"),
        (("next_trouble",), "Next robot with an alarm"),
        (FLOOR_STEPS, "Next, previous floor"),
        (("palette",), "A robot, place or floor by name"),
    ),
    "See what is wrong": (
        (("why",), "Why the robot is not moving"),
        (("robot_page",), "The robot's page: values, ages"),
        (("acknowledge", "acknowledge_all"), "Acknowledge this alarm; all alarms"),
        (("all_orders",), "Orders of this robot, or of all"),
        (("diagnostics",), "Diagnostics: links, topics, logs"),
        (("bundle",), "Pack an incident for a ticket"),
    ),
    "Look back in time": (
        (("audit", "history"), "Audit log; history of the robots"),
        (("palette",), "Type record, for fleet-tui replay"),
    ),
    "Look around on the map": (
        (("zoom_in", "zoom_out", "fit"), "Zoom in, out, fit (mouse wheel)"),
        (("pan_left", "pan_right", "pan_up", "pan_down"), "Pan (mouse drag)"),
        (("follow", "centre"), "Follow, or centre on the robot"),
        (("edges", "labels", "trails"), "Show edges, labels, trails"),
        (("laser", "path"), "Show laser scan, planned path"),
        (("next_vertex", "previous_vertex"), "Next, previous labelled vertex"),
    ),
    "Set up a site": (
        (("edit",), "Draw the route graph"),
        (("pose",), "Set the robot's pose"),
        (("mapping",), "Mapping: on, off, save the map"),
        (("drive",), "Drive the robot by hand"),
        (("camera",), "Look through the robot's camera"),
        (("programs",), "Programs of the robot servers"),
        (("routines",), "Routines: instructions from a file"),
    ),
    "Get around": (
        (("next_pane",), "Next pane"),
        (("enlarge",), "Enlarge the pane; once more: back"),
        (("menu",), "Menu of a row in a table"),
        (("filter_rows",), "Filter the table by what you type"),
        (("mark_row",), "Mark rows: a command goes to all"),
        (("palette",), "Any action, found by typing"),
        (("back",), "One level back"),
        (("quit",), "Quit"),
    ),
}


def tasks(keys: Mapping[str, tuple[str, ...]], hidden: Collection[str]) -> list[HelpSection]:
    """Return the tasks with their keys as configured, the first of each id, without the `hidden` ones. Where
    no order can be sent, no way to do so is offered."""
    sections = []
    away = {*hidden, *outdone(keys, hidden)}
    for title, steps in TASKS.items():
        if title == ORDERING and "order" in hidden:
            continue
        offered = [([id_ for id_ in ids if id_ not in away], text) for ids, text in steps]
        rows = tuple(key_row(ids, text, keys, 1) for ids, text in offered if ids)
        if rows:
            sections.append(HelpSection(title, rows))
    return sections
