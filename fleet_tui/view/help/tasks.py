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
    "See what is wrong": (
        (("why", "robot_page"), "Why it is stuck, not moving; its page"),
        (("acknowledge", "acknowledge_all"), "Acknowledge the alarm; all alarms"),
        (("all_orders",), "Orders of the robot, or of all"),
        (("diagnostics",), "Diagnostics: links, topics, logs"),
        (("bundle", "programs", "routines"), "Incident; programs; routines"),
    ),
    "Look around on the map": (
        (("zoom_in", "zoom_out", "fit"), "Zoom in, out, fit (mouse wheel)"),
        (("pan_left", "pan_right", "pan_up", "pan_down"), "Pan (mouse drag)"),
        (("follow", "centre"), "Follow, or centre on the robot"),
        (("edges", "labels", "trails"), "Show edges, labels, trails"),
        (("next_vertex", "previous_vertex"), "Next, previous labelled vertex"),
    ),
    "Choose a robot or a floor": (
        ((*ROBOT_STEPS, *ROBOTS), "Next, previous robot; by number"),
        (("next_trouble", *FLOOR_STEPS), "Robot of the next alarm; floors"),
    ),
    "Look back in time": (
        (("audit",), "Audit log: all commands and alarms"),
        (("palette",), "Type record, for fleet-tui replay"),
    ),
    "Get around": (
        (("next_pane", "enlarge"), "Next pane; enlarge it"),
        (("mark_row", "menu"), "Mark several robots; row menu"),
        (("palette", "filter_rows"), "Find anything; filter rows"),
        (("back", "quit"), "One level back; quit"),
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
