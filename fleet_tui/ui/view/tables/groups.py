"""The fleet's rows in groups by floor or by link, each of which can be folded."""

from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import NamedTuple

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.activity import activities
from fleet_tui.text.language import counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.doing import ODD, count_text, count_word
from fleet_tui.ui.view.tables.short_names import floor_text
from fleet_tui.ui.view.tables.table import Row, Run

FOLDED = "+ "
UNFOLDED = "- "


class GroupHead(NamedTuple):
    """The key of the head row of a group of robots: by what they are grouped, and its name."""

    by: str
    name: str


class RowGroups:
    """By what rows are grouped, empty for not at all, and the folded groups."""

    def __init__(self) -> None:
        self.by = ""
        self.folded: set[GroupHead] = set()

    def next(self, state: FleetState) -> bool:
        """Group by the next value that tells robots apart, after the last one not at all. Return False if
        there is none."""
        names = ["", *(by for by in BY if len({BY[by](state, robot) for robot in state.robots.values()}) > 1)]
        self.by = names[(names.index(self.by) + 1) % len(names)] if self.by in names else ""
        return len(names) > 1

    def fold(self, head: GroupHead) -> None:
        """Fold a group, or unfold it."""
        self.folded ^= {head}

    def grouped(
        self, state: FleetState, robots: Sequence[Robot], kept: str, opens: bool
    ) -> list[GroupHead | Robot]:
        """Return the heads of groups, each before its robots in their order, those of a folded one without
        them but for the robot `kept`. `opens`: all groups are unfolded."""
        if not self.by:
            return list(robots)
        groups: dict[GroupHead, list[Robot]] = {}
        for name in _names(state, self.by):
            groups[GroupHead(self.by, name)] = []
        for robot in robots:
            groups[GroupHead(self.by, BY[self.by](state, robot))].append(robot)
        found: list[GroupHead | Robot] = []
        for head, members in groups.items():
            hides = head in self.folded and not opens
            if members:
                found += [head, *(robot for robot in members if not hides or robot.name == kept)]
        return found


BY: Mapping[str, Callable[[FleetState, Robot], str]] = {
    "floor": floor_text,
    "link": lambda _state, robot: robot.link,
}
"""What rows can be grouped by."""


def _names(state: FleetState, by: str) -> Sequence[str]:
    """Return the names of groups in the order of the configuration, then the others."""
    found = {BY[by](state, robot) for robot in state.robots.values()}
    usual = [name for name in (state.floors if by == "floor" else state.links) if name in found]
    return [*usual, *sorted(found - set(usual))]


def head_row(state: FleetState, head: GroupHead, is_folded: bool, troubled: Collection[str]) -> Row:
    """Return the head of a group: how many robots are in it, in trouble and offline, and if they are folded
    also how many are blocked, at an obstacle or paused."""
    members = [robot for robot in state.robots.values() if BY[head.by](state, robot) == head.name]
    count = len(members)
    alarmed = sum(robot.name in troubled for robot in members)
    offline = sum(not state.is_online(robot) for robot in members)
    runs: list[Run] = [
        (FOLDED if is_folded else UNFOLDED, StyleRole.KEY),
        (sanitize(head.name), StyleRole.TITLE),
        (" " + translate(counted("{count} robot", "{count} robots", count)), StyleRole.DIM),
    ]
    if alarmed:
        runs.append(
            (" " + translate(counted("{count} with alarm", "{count} with alarms", alarmed)), StyleRole.ALARM)
        )
    if offline:
        runs.append((tr(" {offline} offline", offline=offline), StyleRole.WARN))
    done = activities(state, members) if is_folded else {}
    words = Counter(count_word(state, robot, done.get(robot.name)) for robot in members if is_folded)
    for one in ODD:
        if words[one]:
            runs.append((f" {count_text(words[one], one)}", StyleRole.WARN))
    return Row(head, tuple(runs))
