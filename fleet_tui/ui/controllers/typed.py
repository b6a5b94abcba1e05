"""A line of the palette as a command."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Protocol

from fleet_tui.commands.checks import acceptable, not_accepted
from fleet_tui.commands.language.completion import complete, is_command
from fleet_tui.commands.language.grammar import parse
from fleet_tui.commands.rights import needed_for
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message, message_of, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.lines.questions import request_text

Entry = tuple[Message, Callable[[], object]]
"""A line to choose, and its action."""


class OpenMenu(Protocol):
    """Opens a menu: its title, its entries, and the place of the marked one."""

    def __call__(
        self, title: Message, entries: Sequence[Entry], marked: int = 0, *, searched: bool = False
    ) -> None:
        """Open it. Actions have keys; a list of things is `searched`: it filters as one types."""


ALL = Permissions()


@dataclass(frozen=True)
class Typed:
    """A typed line: the effect of Enter, completions, and the error so far."""

    entries: Sequence[Entry] = ()
    completed: Sequence[str] = ()
    problem: Message = EMPTY

    @property
    def is_command(self) -> bool:
        """Tell whether it is a command, complete or not."""
        return bool(self.entries or self.problem)


def typed(
    line: str, state: FleetState, selected: str, do: Callable[[Request], None], allowed: Permissions = ALL
) -> Typed:
    """Return the command of a line, if `do` can run it, and its user may give it."""
    completed = complete(line, state, selected)
    if not is_command(line, state):
        return Typed(completed=completed)
    try:
        request = parse(line, state, selected)
    except CommandError as problem:
        return Typed(completed=completed, problem=sanitize(message_of(problem)))
    if refusal := allowed.refusal(needed_for(request.commands)):
        return Typed(problem=refusal)
    if impossible := not_accepted(state, acceptable(state, request)[0].commands):
        return Typed(completed=completed, problem=sanitize(impossible[0].text))
    return Typed([(verbatim(request_text(state, request)), partial(do, request))], completed)
