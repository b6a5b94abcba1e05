"""Requests to robots beside orders: pause and resume, and the menu of a robot."""

from collections.abc import Callable, Iterator
from functools import partial

from fleet_tui.commands.routes.charging import way_to_charger
from fleet_tui.keys.key import key_name
from fleet_tui.model import kind
from fleet_tui.model.commands import ClearOrders, PauseRobot, ResumeRobot
from fleet_tui.model.problem import Right
from fleet_tui.model.request import Request
from fleet_tui.situation.alarms.trouble import needs_a_look
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.ordering.orders import OrderRequests
from fleet_tui.ui.controllers.tables.marked import MarkedCommands
from fleet_tui.ui.controllers.typed import Entry


class RobotRequests:
    """Turns a key or a row of the fleet into a request; `why` opens the reasons why a robot stands still,
    `alarm_menu` the menu of an alarm, by source and kind."""

    def __init__(
        self,
        console: Console,
        *,
        orders: OrderRequests,
        why: Callable[[], None],
        alarm_menu: Callable[[str, str], None],
        marked: MarkedCommands,
    ) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._notices = console.notices
        self._navigation = console.navigation
        self._orders = orders
        self._open_menu = console.open_menu
        self._why = why
        self._alarm_menu = alarm_menu
        self._marked = marked
        self._keys = console.settings.keys

    def pause(self) -> None:
        """Pause the selected robot, or all marked ones, at once."""
        self._marked.do(self._navigation.robot, PauseRobot)

    def resume(self) -> None:
        """Resume the selected robot at once, or all marked ones after asking."""
        self._marked.do(self._navigation.robot, ResumeRobot)

    def pause_all(self) -> None:
        """Pause every robot, at once."""
        self._dispatch.do(Request(tuple(map(PauseRobot, self._store.state.robots))))

    def resume_all(self) -> None:
        """Resume every robot that is paused, after a question."""
        state = self._store.state
        heard = filter(state.is_online, state.robots.values())
        able = [robot for robot in heard if robot.kind.can(kind.RESUME)]
        paused = tuple(ResumeRobot(robot.name) for robot in able if state.is_paused(robot))
        if paused:
            self._dispatch.do(Request(paused), asks=True)
        else:
            self._notices.say(Message("no robot is paused"))

    def menu(self, robot: str) -> None:
        """List the actions for a robot; the mark is on the one that explains what is wrong with it, if
        something is: each number means the same for all robots."""
        state = self._store.state
        fault, entries = state.robots[robot].last_fault, list(self._entries(robot))
        explain = next(place for place, (text, _) in enumerate(entries) if text == self._explain)
        marked = explain if needs_a_look(state, robot) else 0
        self._open_menu(
            Message("{robot}: {text}", robot=robot, text=sanitize(fault)) if fault else verbatim(robot),
            entries,
            marked,
        )

    def _entries(self, robot: str) -> Iterator[Entry]:
        known, do = self._store.state.robots[robot], self._dispatch.do
        asked = (
            (Message("Order"), kind.ORDER, self._orders.start),
            (Message("Pause"), kind.PAUSE, partial(do, Request((PauseRobot(robot),)))),
            (Message("Resume"), kind.RESUME, partial(do, Request((ResumeRobot(robot),)))),
            (Message("Clear all orders"), kind.CLEAR, partial(do, Request((ClearOrders(robot),)))),
        )
        if not self._dispatch.permissions.refusal(Right.DISPATCH):
            for text, verb, action in asked:
                if known.kind.can(verb):
                    yield self._with_key(text, verb), partial(self._for, robot, action)
        yield Message("Show on the map"), partial(self._navigation.find_robot, robot)
        yield self._explain, partial(self._for, robot, self._why)
        may_order = known.kind.can(kind.ORDER) and not self._dispatch.permissions.refusal(Right.DISPATCH)
        if may_order and way_to_charger(self._store.state, known):  # below what all robots have
            charge = partial(self._for, robot, self._orders.charge_now)
            yield self._with_key(Message("Send to the nearest charger"), "charge"), charge
        yield from self._alarms(robot)

    @property
    def _explain(self) -> Message:
        return self._with_key(Message("Explain why it is not moving"), "why")

    def _with_key(self, text: Message, id_: str) -> Message:
        """Return an entry with the key that chooses it, as it does outside of the menu."""
        return text + "".join(f" ({key_name(key)})" for key in self._keys[id_][:1])

    def _alarms(self, robot: str) -> Iterator[Entry]:
        for alarm in self._store.state.alarms:
            if alarm.condition.source == robot:
                yield (
                    Message("Alarm: {text} ...", text=sanitize(alarm.text)),
                    partial(self._alarm_menu, *alarm.key),
                )

    def _for(self, robot: str, action: Callable[[], None]) -> None:
        self._navigation.select(robot)
        action()
