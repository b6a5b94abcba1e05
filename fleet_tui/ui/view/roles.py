"""Style roles: every colour by its meaning. A theme gives each a style; no other module knows colours."""

from enum import IntEnum, auto


class StyleRole(IntEnum):
    """The meaning of a piece of text on the map or in a pane; fits in a uint8 plane."""

    FLOOR = 0
    UNKNOWN = auto()
    WALL = auto()
    WALL_BEYOND = auto()
    """A wall surrounded by unknown ground: it is drawn on the darker ground."""
    WALL_SOLID = auto()
    """A cell full of wall: the ground is of the wall's colour, too, for fonts whose blocks leave gaps."""
    EDGE = auto()
    TRAIL = auto()
    TRAIL_OLD = auto()
    SCAN = auto()
    """The ends of the laser's beams."""
    MISSION_NEXT = auto()
    """The way of the orders after the current one."""
    MISSION = auto()
    """The way the selected robot is driving."""
    MISSION_NEXT_THROUGH = auto()
    MISSION_THROUGH = auto()
    """The same ways through a wall, on the wall's colour."""
    VERTEX = auto()
    VERTEX_LABELLED = auto()
    ELEVATOR = auto()
    DOCKING = auto()
    LABEL = auto()
    LABEL_BEYOND = auto()
    """A label on unknown ground."""
    LABEL_THROUGH = auto()
    """A label over a wall, on the wall's colour: it hides none."""
    TARGET_THROUGH = auto()
    TARGET_BEYOND = auto()
    TARGET = auto()
    """The ends of the selected robot's order, vertex and label."""
    CURSOR = auto()
    ROBOT_BODY = auto()
    ROBOT_BODY_ALARM = auto()
    """The outline of a robot drawn to scale."""
    ROBOT = auto()
    ROBOT_SELECTED = auto()
    ROBOT_OFFLINE = auto()
    ROBOT_WARN = auto()
    ROBOT_ALARM = auto()
    CARGO = auto()
    TEXT = auto()
    DIM = auto()
    TITLE = auto()
    TITLE_FOCUSED = auto()
    RULE = auto()
    ACCENT = auto()
    GOOD = auto()
    WARN = auto()
    ALARM = auto()
    KEY = auto()
    CURSOR_ROW = auto()
    """The ground of the row that keys are for; its texts keep their own colours."""


WALLS = (StyleRole.WALL, StyleRole.WALL_BEYOND, StyleRole.WALL_SOLID)
"""All roles of walls with nothing over them."""

LABELS = (
    StyleRole.LABEL,
    StyleRole.LABEL_BEYOND,
    StyleRole.LABEL_THROUGH,
    StyleRole.TARGET_THROUGH,
    StyleRole.TARGET_BEYOND,
    StyleRole.TARGET,
)
"""Roles of labels, and of the order's ends."""
