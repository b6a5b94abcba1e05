"""Everything that happened, as one list: orders, alarms, commands, links and notes by their time."""

from collections.abc import Iterable, Sequence
from enum import Enum

from msgspec import Struct

from fleet_tui.model.commands import FAILURES, Stage
from fleet_tui.model.history.facts import LinkChange, Note
from fleet_tui.model.history.lives import AlarmLife, PastCommand, PastOrder
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import EMPTY, Message, joined, tr, translate, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age

TROUBLE = frozenset(stage.value for stage in FAILURES)
DONE = Stage.DONE.value


class EventKind(Enum):
    """The subject of an event; the value is typed in filters, and stands in JSON and CSV."""

    ORDER = "order"
    ALARM = "alarm"
    COMMAND = "command"
    LINK = "link"
    NOTE = "note"


class PastEvent(Struct, frozen=True):
    """One line of a history. Unix seconds: `at` its begin, `ended` its end, None while it goes on or if it
    has none. `subject` is the robot or link, `what` its name, `outcome` how it ended in a word or two,
    `detail` the reason and the durations; `is_trouble`: somebody had to look; `begun`: when a robot began an
    order, None if it did not, or nobody saw it."""

    at: float
    ended: float | None
    kind: EventKind
    subject: str
    what: Message
    outcome: Message
    detail: Message = EMPTY
    operator: str = ""
    is_trouble: bool = False
    begun: float | None = None

    @property
    def told_at(self) -> float:
        """Return the time of what its text says: of an order its last step, of all else its begin."""
        steps = (self.ended, self.begun) if self.kind is EventKind.ORDER else ()
        return next((step for step in steps if step is not None), self.at)

    @property
    def text(self) -> str:
        """Return it as a line without its time, which no terminal executes."""
        by = tr(", by {operator}", operator=self.operator) if self.operator else ""
        subject = f"{self.subject} " if self.subject else ""
        outcome = f": {translate(self.outcome)}" if self.outcome else ""
        what = self.what if self.kind is EventKind.NOTE else translate(self.what)  # a person's own words
        return sanitize(f"{subject}{what}{outcome}{translate(detail_text(self.detail))}{by}")


def past_events(
    orders: Iterable[PastOrder] = (),
    alarms: Iterable[AlarmLife] = (),
    commands: Iterable[PastCommand] = (),
    links: Iterable[LinkChange] = (),
    notes: Iterable[Note] = (),
) -> list[PastEvent]:
    """Return all as events, oldest first by what they say."""
    events = [
        *map(_of_order, orders),
        *map(_of_alarm, alarms),
        *map(_of_command, commands),
        *map(_of_link, links),
        *(
            PastEvent(note.at, None, EventKind.NOTE, "", verbatim(note.text), EMPTY, EMPTY, note.operator)
            for note in notes
        ),
    ]
    return sorted(events, key=lambda event: event.told_at)


def matching(events: Iterable[PastEvent], words: Sequence[str], robot: str = "") -> list[PastEvent]:
    """Return the events of a robot (empty: all) that contain every word, or not a `!word`."""
    wanted = [word.casefold() for word in words if not word.startswith("!")]
    unwanted = [word[1:].casefold() for word in words if word.startswith("!") and word[1:]]
    found = []
    for event in events:
        line = f"{event.kind.value} {event.text}".casefold()
        if robot not in ("", event.subject):
            continue
        if all(word in line for word in wanted) and not any(word in line for word in unwanted):
            found.append(event)
    return found


def _of_order(order: PastOrder) -> PastEvent:
    begun, ended = order.begun, order.ended
    took = []
    if begun is not None and begun - order.queued >= 1.0:
        took.append(Message("waited {age}", age=age(begun - order.queued)))
    # An end that nobody saw is kept as its begin.
    if begun is not None and ended is not None and ended > begun:
        took.append(Message("driven in {age}", age=age(ended - begun)))
    # An order that is done needs no reason.
    reason = [] if order.stage == DONE or not order.reason else [Message(order.reason)]
    return PastEvent(
        order.queued,
        ended,
        EventKind.ORDER,
        order.robot,
        Message("order {order} {way}", order=order.order, way=order.way),
        Message(order.stage),
        joined(", ", [*reason, *took]),
        order.operator,
        order.stage in TROUBLE,
        begun,
    )


def _of_alarm(alarm: AlarmLife) -> PastEvent:
    over = alarm.returned if alarm.returned is not None else alarm.ended
    lasted = (
        Message("held {age}", age=age(over - alarm.raised)) if over is not None else Message("still holds")
    )
    if alarm.returned is None and over is not None:
        lasted = Message("end not seen, held at least {age}", age=age(over - alarm.raised))
    seen = (
        [Message("acknowledged after {age}", age=age(alarm.acknowledged - alarm.raised))]
        if alarm.acknowledged
        else []
    )
    times = [Message("{count} times", count=alarm.count)] if alarm.count > 1 else []
    return PastEvent(
        alarm.raised,
        over,
        EventKind.ALARM,
        alarm.source,
        Message("{kind} alarm, {text}", kind=alarm.kind, text=Message(alarm.text)),
        lasted,
        joined(", ", [*times, *seen]),
        alarm.operator,
        True,
    )


def _of_command(command: PastCommand) -> PastEvent:
    what = Message(command.what)
    return PastEvent(
        command.at,
        None,
        EventKind.COMMAND,
        command.robot,
        Message("{what} {way}", what=what, way=command.way) if command.way else what,
        Message(command.stage),
        Message(command.reason),
        command.operator,
        command.stage in TROUBLE,
    )


def _of_link(link: LinkChange) -> PastEvent:
    outcome = Message("up") if link.is_up else Message("lost")
    return PastEvent(
        link.at,
        None,
        EventKind.LINK,
        link.link,
        Message("link"),
        outcome,
        Message(link.reason),
        "",
        not link.is_up,
    )
