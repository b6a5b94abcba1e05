"""One line of the audit log, as docs/audit.md describes it."""

import msgspec

from fleet_tui.text.language import Message

VERSION = 2
"""Version of the fields below. It grows when one changes its meaning; a new field leaves it as it is. Before
1, ids of vertices and orders were numbers; they are read as text."""


class AuditRecord(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """One change of a command, an alarm or the console itself. Empty fields are not written.

    `time` is ISO 8601 with the offset. `kind` is command, alarm or console; `what` is its name (order, pause,
    offline, ...), `change` the event (sent, refused, raised, ...) and `words` the reason, or the robot's own
    words. `id` is the request id of a command, `order` the id of an order in the robot's queue; `start` and
    `end` are vertex ids, or poses in metres; `floor` is the robot's floor.
    """

    version: int
    time: str
    operator: str
    console: str
    run: str
    kind: str
    what: str
    change: str
    robot: str = ""
    words: str = ""
    id: int | None = None
    start: str | None = None
    start_label: str = ""
    end: str | None = None
    end_label: str = ""
    order: str | None = None
    floor: str = ""
    link: str = ""
    url: str = ""
    priority: str = ""
    count: int = 0
    demo: bool = False


class PastAlarm(msgspec.Struct, frozen=True):
    """An alarm of this session that is over, with the local times of its begin and end."""

    kind: str
    text: Message
    began: str
    ended: str
