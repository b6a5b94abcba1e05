"""Answers to service calls: their meaning for a command."""

import re
from collections.abc import Sequence

from fleet_tui.model.commands import Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.limits import truncate

LONGEST_JUDGED = 100_000
"""Characters of an answer that are searched for words of refusal: 8 MB would take seconds."""


_NEVER_ARRIVED = re.compile(
    r"^Service \S+ does not exist"
    r"|does not have a field|message requires an? |is not a primitive type|not supported between instances"
    r"|^Unable to (communicate with|import)"
)
"""A bridge's messages for a call that it did not pass on. Any other failure may have run: the node died, its
handler raised an exception midway, or the bridge timed out."""
_THREW = re.compile(r"^service .*responded with an error: ")
"""A bridge's prefix of an exception in a handler: the rest may contain the same words."""

_ALREADY = {
    PauseRobot: re.compile(r"\balready paused\b", re.IGNORECASE),
    ResumeRobot: re.compile(r"\balready running\b|\bnot paused\b", re.IGNORECASE),
}
"""Words with which a robot declines a request that is already fulfilled."""


def said(values: object) -> str:
    """Write the values of an answer as text."""
    try:
        return str(values)
    except RecursionError:
        return "nested too deep"


def judge(
    command: Command, values: object, result: bool, refusals: Sequence[re.Pattern[str]]
) -> tuple[Stage, Message]:
    """Return the stage for the end of a call. A refusal may be in an answer to a successful call.

    An answer has `success`, or is a `status` text; one with neither has no meaning.
    """
    if not result:
        text = truncate(said(values))
        refused = _NEVER_ARRIVED.search(text) and not _THREW.search(text)
        return (Stage.REFUSED if refused else Stage.UNKNOWN), verbatim(text)
    fields = values if isinstance(values, dict) else {}
    success, detail = fields.get("success"), fields.get("status", fields.get("message"))
    if isinstance(command, SetUpCommand) and not fields:
        return Stage.ACCEPTED, EMPTY  # of a service that has no answer
    if not isinstance(success, bool) and not ("success" not in fields and isinstance(detail, str)):
        return Stage.UNKNOWN, Message("unrecognised reply: {reply}", reply=truncate(said(values)))
    text = detail if isinstance(detail, str) else ""
    already = _ALREADY.get(type(command))
    if already is not None and already.search(text, 0, LONGEST_JUDGED):
        return Stage.ACCEPTED, verbatim(truncate(text))
    declined = success is False or any(pattern.search(text, 0, LONGEST_JUDGED) for pattern in refusals)
    return (Stage.REFUSED if declined else Stage.ACCEPTED), verbatim(truncate(text))
