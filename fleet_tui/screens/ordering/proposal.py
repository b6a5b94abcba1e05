"""The robot that would take an order for anyone, shown while the order is typed."""

import math
from collections.abc import Callable

from msgspec.structs import replace
from textual.widgets import Static

from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.language.lookup import Place
from fleet_tui.rules.routes.dispatching import to_any
from fleet_tui.rules.routes.nearest import Nearest, nearest, why_none
from fleet_tui.rules.routes.order_draft import Draft
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize

CHOSEN = "the dispatcher chooses the robot"
AGAIN = 1.0
"""Seconds after which the nearest robot is looked for again: it takes a search of every graph."""


class Proposal(Static):
    """Shows the nearest idle robot with the reason for it, why none can drive the order, or that a dispatcher
    chooses."""

    def __init__(self, state: Callable[[], FleetState]) -> None:
        super().__init__(id="proposal", markup=False)
        self._state = state
        self._found: Nearest | None = None
        self._places: tuple[Place, ...] = ()
        self._at = -math.inf
        self.display = False

    def on(self, draft: Draft) -> Draft | None:
        """Return a draft without a robot as that of the nearest idle one, None without one; a draft with a
        robot hides the proposal."""
        self._look(() if draft.robot else draft.places)
        if draft.robot or self._found is None:
            return draft if draft.robot else None
        return replace(draft, robot=self._found.robot, places=self._found.places)

    def _look(self, places: tuple[Place, ...]) -> None:
        state = self._state()
        if places == self._places and (not places or state.now - self._at < AGAIN):
            return
        self._places = places
        self._at = state.now
        is_dispatched = to_any(state, places) is not None
        self._found = nearest(state, places) if places and not is_dispatched else None
        reason = why_none(state, places) if places and not is_dispatched else CHOSEN * is_dispatched
        self.update(tr(sanitize(self._found.text if self._found is not None else reason)))
        self.display = bool(places)
