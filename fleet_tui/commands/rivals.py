"""Other operators who command a robot at the same time as this console: each of them is told who else did."""

from collections.abc import Iterator

from fleet_tui.model.commands import NOT_LEFT
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import Message, joined

AT_ONCE = 10.0
"""Seconds between two commands to one robot within which they are given at once."""
SHOWN_FOR = 30.0
"""Seconds for which that is told."""


def rivals(state: FleetState, robot: str) -> list[CommandElsewhere]:
    """Return the newest command of each other console that commands a robot at once with this one."""
    found: dict[str, CommandElsewhere] = {}
    for command in state.desk.elsewhere:
        if command.robot == robot and any(_are_at_once(state, command)):
            found[command.console] = command
    return list(found.values())


def _are_at_once(state: FleetState, command: CommandElsewhere) -> Iterator[bool]:
    if state.now - command.at > AT_ONCE + SHOWN_FOR:
        return
    for record in state.commands:
        if record.command.robot == command.robot and record.stage not in NOT_LEFT:
            newest = max(record.issued_at, command.at)
            yield abs(record.issued_at - command.at) < AT_ONCE and state.now - newest < SHOWN_FOR


def rivals_text(state: FleetState, robot: str) -> Message:
    """Return who else commands a robot, from where and what, empty for nobody."""
    return joined(
        ", ",
        (
            Message("{by} at {console}: {what}", by=one.by, console=one.console, what=Message(one.what))
            for one in rivals(state, robot)
        ),
    )
