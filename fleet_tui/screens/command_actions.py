"""The commands of the main screen: from a key or a button to a Command."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from fleet_tui.model.commands import PauseRobot, ResumeRobot, Wish
from fleet_tui.model.events import Event
from fleet_tui.screens.order_actions import OrderActions
from fleet_tui.screens.overlay import Overlay
from fleet_tui.view.text import visible
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
        self.do(Wish((PauseRobot(self.selection.robot),)))

    def action_resume(self) -> None:
        """Resume the selected robot, at once."""
        self.do(Wish((ResumeRobot(self.selection.robot),)))

    def action_pause_all(self) -> None:
        """Pause every robot, at once."""
        self.do(Wish(tuple(map(PauseRobot, self.state.robots))))

    def action_why(self) -> None:
        """Why the selected robot stands still."""
        self.why.show()

    def robot_menu(self, robot: str) -> None:
        """What can be done with a robot."""
        fault = self.state.robots[robot].last_fault
        self.menu.show(
            f"{robot}: {visible(fault)}" if fault else robot,
            [
                ("Order", lambda: self._for(robot, self.action_order)),
                ("Pause", lambda: self._for(robot, self.action_pause)),
                ("Resume", lambda: self._for(robot, self.action_resume)),
                ("Clear all orders", lambda: self._for(robot, self.action_clear)),
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
