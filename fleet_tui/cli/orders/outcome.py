"""The outcome of one command, as a line or as JSON. docs/commands.md has the schema."""

import json
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass

from fleet_tui.commands.language.grammar import written
from fleet_tui.model.commands import Command, CommandRecord, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.commands import command_text

VERSION = 2
DONE = 0
NOT_DONE = 1
USAGE = 2
NO_LINK = 3
SUCCESSES = frozenset({Stage.CONFIRMED, Stage.UNVERIFIABLE})
NOT_SENT = Stage.NOT_SENT.value


@dataclass(frozen=True, slots=True)
class Outcome:
    """`command` as typed, empty if it can't be, `text` in words; `outcome` is the stage at which it ended,
    with the robot's or the console's own `words`; `code` is its exit code."""

    robot: str
    command: str
    text: str
    outcome: str
    words: str
    code: int
    order_id: str | None = None
    seconds: float | None = None

    def line(self) -> str:
        """Return the outcome in one line, safe for a terminal."""
        return sanitize(f"{self.text}: {self.outcome}{detail_text(self.words)}")


def unsent(state: FleetState, command: Command, words: str, code: int, outcome: str = NOT_SENT) -> Outcome:
    """Return the outcome of a command that was never sent."""
    return _outcome(state, command, outcome, words, code)


def ended(state: FleetState, record: CommandRecord, waited: float) -> Outcome:
    """Return the outcome of a command that was sent; `waited`: for how many seconds, if it has not ended."""
    # An order may have advanced already: the step that decided the command counts.
    step = record.outcome or record.steps[-1]
    words, code, outcome = step.detail, NOT_DONE, step.stage.value
    if step.stage in SUCCESSES:
        code = DONE
    elif not record.is_decided:
        why = f"last stage {outcome} {words}".strip()
        outcome = Stage.UNKNOWN.value
        words = Message(
            "{why}; no further report within {waited} s: may still be carried out",
            why=why,
            waited=f"{waited:.0f}",
        )
    seconds = round(step.at - record.issued_at, 3) if record.is_decided else None
    return _outcome(state, record.command, outcome, words, code, record.order_id, seconds)


def _outcome(
    state: FleetState,
    command: Command,
    outcome: str,
    words: str,
    code: int,
    order_id: str | None = None,
    seconds: float | None = None,
) -> Outcome:
    typed, text = written(command, state), command_text(state, command)
    return Outcome(command.robot, typed, text, outcome, words, code, order_id, seconds)


def print_outcome(outcome: Outcome, as_json: bool, say: Callable[..., None]) -> None:
    """Print an outcome: JSON to stdout, a line to stdout or, for a failure, to stderr."""
    if as_json:
        values = {"version": VERSION, **asdict(outcome), "done": outcome.code == DONE}
        del values["text"], values["code"]
        say(json.dumps(values))
    else:
        say(outcome.line(), err=outcome.code != DONE)


def exit_code(codes: Iterable[int]) -> int:
    """Return one exit code for several: no link and wrong usage only if all have that."""
    found = set(codes) or {DONE}
    return found.pop() if len(found) == 1 else NOT_DONE
