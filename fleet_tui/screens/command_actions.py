"""The commands of the main screen: from a key or a button to a Command."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from fleet_tui.model import kind
from fleet_tui.model.commands import PauseRobot, ResumeRobot
from fleet_tui.model.events import Event
from fleet_tui.model.request import Request
from fleet_tui.rules.commands.keeping import hold_all
from fleet_tui.screens.order_actions import OrderActions
from fleet_tui.screens.overlay import Overlay
from fleet_tui.text.sanitize import sanitize
from fleet_tui.widgets.bindings import OPENING_ACTIONS, SELECTING_ACTIONS

if TYPE_CHECKING:
    from fleet_tui.screens.why import Why


class CommandActions(OrderActions):
    """What can be asked of robots from here."""

    tell: Callable[[Event], None]
    why: "Why"

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """What comes before all else does not reach through what is open already."""
        if action not in OPENING_ACTIONS | SELECTING_ACTIONS:
            return True
        opened = [overlay for overlay in self.query(Overlay) if overlay.is_open]
        return not opened or (action in SELECTING_ACTIONS and opened == [self.why])

    def action_pause(self) -> None:
        """Pause the selected robot, at once."""
        self.do(Request((PauseRobot(self.selection.robot),)))

    def action_resume(self) -> None:
        """Resume the selected robot, at once."""
        self.do(Request((ResumeRobot(self.selection.robot),)))

    def action_pause_all(self) -> None:
        """Pause every robot, at once."""
        self.do(Request(tuple(map(PauseRobot, self.state.robots))))

    def action_arm(self) -> None:
        """Let commands leave this console, or no longer: orders that wait here neither."""
        self.armed = not self.armed
        for held in () if self.armed else hold_all(self.state, "this console is not armed"):
            self.tell(held)
        self.say("this console is armed" if self.armed else "this console is not armed")

    def action_why(self) -> None:
        """Why the selected robot stands still."""
        self.why.show()

    def robot_menu(self, robot: str) -> None:
        """What can be done with a robot."""
        known = self.state.robots[robot]
        fault = known.last_fault
        asked = (
            ("Order", kind.ORDER, self.action_order),
            ("Pause", kind.PAUSE, self.action_pause),
            ("Resume", kind.RESUME, self.action_resume),
            ("Clear all orders", kind.CLEAR, self.action_clear),
        )
        self.menu.show(
            f"{robot}: {sanitize(fault)}" if fault else robot,
            [
                *((text, partial(self._for, robot, do)) for text, verb, do in asked if known.kind.can(verb)),
                ("Show on the map", lambda: self.find_robot(robot)),
                ("Why does it stand still?", lambda: self._for(robot, self.action_why)),
            ],
        )

    def _for(self, robot: str, action: Callable[[], None]) -> None:
        self.select(robot)
        action()

    def select(self, robot: str) -> None:
        """Select a robot."""
        raise NotImplementedError

    def find_robot(self, robot: str) -> None:
        """Select a robot and bring the map to it."""
        raise NotImplementedError
