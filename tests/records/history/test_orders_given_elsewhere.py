"""An order that another console of this machine drives goal by goal is one order here, too."""

from msgspec.structs import replace

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Stage
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import OrderChange
from fleet_tui.model.order import OrderState
from fleet_tui.records.audit.elsewhere import command_of
from fleet_tui.records.history.observing import Observer
from tests.support.fleets import R0, T0, reduced
from tests.support.legs import DONE, goal, lived, site
from tests.support.records import record

FIRST, SECOND = "goal---1", "goal---2"


class Watcher:
    """A console that gives nothing: it sees goals, and reads the log of the console that gives them."""

    def __init__(self) -> None:
        self.state = site()
        self._observer = Observer()
        self.changes: list[tuple[str, str, str]] = []
        self._see(self.state)

    def _see(self, state: FleetState) -> None:
        self.state = state
        facts = self._observer.observe(state)
        self.changes += [
            (fact.order, fact.way, fact.stage) for fact in facts if isinstance(fact, OrderChange)
        ]

    def goal(self, at: float, name: str, end: OrderState | None = None) -> None:
        listed = goal(name) if end is None else goal(name, end)
        self._see(lived(self.state, T0 + at, listed))

    def read(self, at: float, stage: Stage, order: str | None, words: str = "") -> None:
        url = self.state.links[self.state.robots[R0].link].url
        entry: AuditRecord = replace(
            record(what="order", url=url, change=stage.value, order=order, words=words),
            id=7,
            start="1",
            end="2",
            robot=R0,
        )
        command = command_of(entry, self.state, "host:9", T0 + at)
        assert command is not None
        self._see(reduced(self.state, CommandedElsewhere(command)))

    def first_goal(self) -> None:
        self.read(0.9, Stage.SENT, None)
        self.goal(1.0, FIRST)
        self.read(1.2, Stage.CONFIRMED, FIRST)
        self.goal(2.3, FIRST)
        self.goal(5.0, FIRST, DONE)

    def next_goal_waits(self) -> None:
        self.read(5.2, Stage.WAITING, "k1", f"order {FIRST}: stop reached, next goal follows")


def whole(end: str) -> list[tuple[str, str, str]]:
    return [(FIRST, "1 -> 2", stage) for stage in ("queued", "begun", end)]


def test_its_stop_on_the_way_is_no_end_and_its_next_goal_no_order() -> None:
    watcher = Watcher()
    watcher.first_goal()
    watcher.next_goal_waits()
    watcher.read(5.3, Stage.SENT, "k1")
    watcher.goal(5.4, SECOND)
    watcher.read(5.6, Stage.CONFIRMED, SECOND)
    watcher.goal(7.0, SECOND)
    watcher.goal(9.0, SECOND, DONE)
    watcher.read(9.2, Stage.DONE, SECOND)
    watcher.goal(12.0, SECOND, DONE)
    assert watcher.changes == whole("done")


def test_a_cancellation_between_its_goals_is_its_end() -> None:
    watcher = Watcher()
    watcher.first_goal()
    watcher.next_goal_waits()
    watcher.goal(7.0, FIRST, DONE)
    watcher.read(8.0, Stage.CANCELLED, "k1")
    watcher.goal(12.0, FIRST, DONE)
    assert watcher.changes == whole("cancelled")


def test_a_first_goal_is_no_end_of_an_order_whose_console_has_gone() -> None:
    watcher = Watcher()
    watcher.first_goal()
    watcher.goal(30.0, FIRST, DONE)
    assert watcher.changes == whole("done")[:2]


def test_an_order_whose_robot_stands_at_its_first_stop_begins_with_its_second_goal() -> None:
    watcher = Watcher()
    watcher.read(0.9, Stage.SENT, None)
    watcher.goal(1.2, FIRST, DONE)
    watcher.read(1.3, Stage.CONFIRMED, FIRST)
    watcher.read(1.4, Stage.WAITING, "k1", f"order {FIRST}: stop reached, next goal follows")
    watcher.read(1.5, Stage.SENT, "k1")
    watcher.goal(1.6, SECOND)
    watcher.read(1.9, Stage.CONFIRMED, SECOND)
    watcher.goal(3.0, SECOND)
    assert watcher.changes == whole("done")[:2]
