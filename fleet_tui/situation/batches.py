"""Commands given together: one request to many robots, and its overall state."""

from collections import defaultdict
from collections.abc import Sequence

from fleet_tui.model.commands import Command, CommandRecord, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.pauses import FOREIGN
from fleet_tui.text.language import Message, joined
from fleet_tui.text.limits import some

TOGETHER = 0.3
"""Commands of one kind less than this many seconds apart are one request."""

_WORDS = {
    Stage.CONFIRMED: Message("confirmed"),
    Stage.LATE: Message("confirmed"),
    Stage.UNVERIFIABLE: Message("accepted"),
    Stage.REFUSED: Message("refused"),
    Stage.NOT_SENT: Message("not sent"),
}
_WELL = (Message("confirmed"), Message("accepted"))
_OPEN = Message("open")


def batches(records: Sequence[CommandRecord]) -> list[list[CommandRecord]]:
    """Group commands that were given together, in the order in which they were given. A robot is in a batch
    once."""
    found: list[list[CommandRecord]] = []
    robots = set[str]()
    for record in records:
        last, robot = found[-1][-1] if found else None, record.command.robot
        alike = last is not None and type(last.command) is type(record.command)
        if (
            last is not None
            and alike
            and record.issued_at - last.issued_at < TOGETHER
            and robot not in robots
        ):
            found[-1].append(record)
        else:
            found.append([record])
            robots.clear()
        robots.add(robot)
    return found


def pauses(records: Sequence[CommandRecord]) -> list[list[CommandRecord]]:
    """Return the batches that paused or resumed several robots."""
    return [
        batch
        for batch in batches(records)
        if len(batch) > 1 and isinstance(batch[0].command, PauseRobot | ResumeRobot)
    ]


def batch_name(state: FleetState, commands: Sequence[Command]) -> Message:
    """Return the name of pauses or resumes of several robots: `pause all`, `resume 3 robots`."""
    robots = {command.robot for command in commands}
    if isinstance(commands[0], PauseRobot):
        all_of_them, some_of_them = Message("pause all"), Message("pause {count} robots", count=len(robots))
    else:
        all_of_them, some_of_them = Message("resume all"), Message("resume {count} robots", count=len(robots))
    return all_of_them if robots == set(state.robots) else some_of_them


def summary(state: FleetState, batch: Sequence[CommandRecord]) -> tuple[Message, Message]:
    """Summarise a batch: `pause all` and `98 confirmed, 2 open (robot_5, robot_9)`. Open ones may still be
    carried out, or were, unseen."""
    found: dict[Message, list[CommandRecord]] = defaultdict(list)
    for record in batch:
        found[_WORDS.get(record.stage, _OPEN)].append(record)
    words = dict.fromkeys([*_WELL, *_WORDS.values(), _OPEN])
    parts = [_part(word, found[word]) for word in words if word in found]
    foreign = [record.command.robot for record in batch if record.detail.startswith(FOREIGN)]
    if foreign:
        parts.append(
            Message("goals of other clients stopped, not resumable from here ({some})", some=some(foreign))
        )
    return batch_name(state, [record.command for record in batch]), joined(", ", parts)


def _part(word: Message, records: Sequence[CommandRecord]) -> Message:
    if word in _WELL:
        return Message("{count} {outcome}", count=len(records), outcome=word)
    robots = some(list(dict.fromkeys(record.command.robot for record in records)))
    if word == _OPEN:
        return Message("{count} open ({robots})", count=len(records), robots=robots)
    part = Message("{count} {outcome} ({robots})", count=len(records), outcome=word, robots=robots)
    reasons = {record.detail for record in records}
    return joined(": ", filter(None, (part, *(reasons if len(reasons) == 1 else ()))))
