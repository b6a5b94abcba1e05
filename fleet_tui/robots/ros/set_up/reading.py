"""Messages of set-up as events: the mode of a robot."""

from fleet_tui.model import events
from fleet_tui.model.navigation_events import ModeReported
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros import navigation as nav
from fleet_tui.robots.ros.facts import Translate
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.limits import LONGEST_NAME, truncate

MODES = ("navigation", "mapping")
"""The modes, by the truth of a std_msgs/Bool."""


def read_mode(names: Names) -> Translate:
    """Read a std_msgs/String, in the robot's own words, or a std_msgs/Bool, true for mapping."""
    paths, is_bool = names.paths("mode"), names.type("mode").endswith("/Bool")
    switch, words = ros.reader(ros.Bool, paths), ros.reader(nav.Text, paths)
    known = {word.casefold(): mode for word, mode in names.profile.modes.items()}

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        if is_bool:
            return ModeReported(robot, at, MODES[switch(msg).data])
        word = truncate(words(msg).data.strip(), LONGEST_NAME)
        folded = word.casefold()
        return ModeReported(robot, at, known.get(folded, folded if folded in MODES else word))

    return translate
