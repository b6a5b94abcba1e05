"""Pages of the diagnostics screen, live or frozen."""

import re
import threading
import time
from collections.abc import Callable, Hashable
from enum import IntEnum

from fleet_tui.config.log_file import TAIL
from fleet_tui.model.counters import Raw, TopicCounter, snapshot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.ros_logs import LogLine, Severity
from fleet_tui.situation.alarms.trouble import in_trouble
from fleet_tui.text.language import tr
from fleet_tui.text.units import age
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.terminal.budget import Budget, memory
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.diagnostics.console import OwnFacts, console_table
from fleet_tui.ui.view.tables.diagnostics.health import health_table
from fleet_tui.ui.view.tables.diagnostics.links import Links, link_table
from fleet_tui.ui.view.tables.diagnostics.raw_message import copied, raw_table
from fleet_tui.ui.view.tables.diagnostics.robot_log import lines_of, robot_log_table
from fleet_tui.ui.view.tables.diagnostics.topics import topic_table
from fleet_tui.ui.view.tables.table import Table


class Page(IntEnum):
    """The pages, by their keys."""

    LINK = 1
    TOPICS = 2
    RAW = 3
    LOG = 4
    HEALTH = 5
    CONSOLE = 6


BESIDE = {
    Page.LINK: Page.TOPICS,
    Page.TOPICS: Page.RAW,
    Page.RAW: Page.LOG,
    Page.LOG: Page.HEALTH,
    Page.HEALTH: Page.LOG,
    Page.CONSOLE: Page.LINK,
}
"""The page beside each one on a wide screen."""


class Pages:
    """`topic` is the link and the topic of the messages, `robot` the selected robot, `least` the minimum
    level of the robots' log, `arrangements` the filter and the order of each page, `opened` and
    `opened_lines` the parts and log lines that are shown whole, `width` the cells of a row."""

    def __init__(
        self, state: Callable[[], FleetState], backend: Backend, clock: Callable[[float], str]
    ) -> None:
        self._state = state
        self._backend = backend
        self._clock = clock
        self.topic: tuple[str, str] | None = None
        self.robot = ""
        self.shows_bad = False
        self.least = Severity.INFO
        # `robot_2` in the log is not `robot_22`.
        self.arrangements = {page: RowArrangement(whole_numbers=page is Page.LOG) for page in Page}
        self._troubled = ""
        """The robot in trouble by which the log was filtered last."""
        self.opened: set[Hashable] = set()
        self.opened_lines: set[Hashable] = set()
        self.width = 80
        self._frozen: dict[Page, float] = {}
        self._raw: tuple[Raw | None, str] = (None, "")
        self._lines: tuple[LogLine, ...] = ()

    def links(self) -> Links:
        """Return each link, and its counters."""
        state, counters = self._state(), self._backend.counters
        return [(state.links[name], counter) for name, counter in counters.items() if name in state.links]

    def first_topic(self, robot: str) -> tuple[str, str] | None:
        return next(iter(self._topics(robot)), None)

    def worst_topic(self, robot: str) -> tuple[str, str] | None:
        """Return the topic of a robot that the page has first: one with a problem before the others."""
        own, state = self._topics(robot), self._state()
        keys = topic_table(state, self.links(), state.now, robot).keys
        return min(own, key=keys.index, default=None)

    def _topics(self, robot: str) -> list[tuple[str, str]]:
        found = [(link.name, one) for link, counter in self.links() for one in counter.topics.values()]
        return [(link, one.topic) for link, one in found if one.robot == robot]

    def first_part(self, robot: str) -> Hashable:
        """Return the row of the worst part of a robot's own diagnostics, None without one."""
        name = re.compile(rf"(?<!\w){re.escape(robot)}(?!\w)")
        keys = health_table(self.links(), (), self._state().now).keys
        return next((key for key in keys if isinstance(key, tuple) and name.search(key[1])), None)

    def begin_log(self, robot: str) -> None:
        """Filter the log by a robot of several if that is in trouble, unless there is a filter."""
        state, log = self._state(), self.arrangements[Page.LOG]
        if log.typed in ("", self._troubled):
            self._troubled = robot if len(state.robots) > 1 and robot in in_trouble(state) else ""
            log.typed = self._troubled

    @property
    def shows_troubled(self) -> bool:
        """Tell whether the log is filtered by a robot in trouble."""
        return bool(self._troubled) and self.arrangements[Page.LOG].typed == self._troubled

    def table(self, page: Page, budget: Budget) -> Table:
        state, links = self._state(), self.links()
        arranged = self.width, self.arrangements[page]
        # In a recording the time may be earlier now, before the frozen message.
        self._frozen = {one: at for one, at in self._frozen.items() if at <= state.now}
        match page:
            case Page.LINK:
                return link_table(links, state.now, *arranged)
            case Page.TOPICS:
                return topic_table(state, links, state.now, self.robot, *arranged)
            case Page.RAW:
                return self._raw_table(state)
            case Page.LOG:
                if page not in self._frozen:
                    self._lines = lines_of(links)
                return self._log_table(links, state)
            case Page.HEALTH:
                return health_table(links, self.opened, state.now, *arranged)
            case Page.CONSOLE:
                return console_table(_own_facts(budget), snapshot(TAIL.lines), *arranged)

    def _log_table(self, links: Links, state: FleetState) -> Table:
        # The id of a line that is gone may be that of another one.
        self.opened_lines &= {id(line) for line in self._lines} if self.opened_lines else set()
        arranged = self.width, self.arrangements[Page.LOG]
        opened = self.opened_lines
        return robot_log_table(self._lines, links, state, self._clock, self.least, opened, *arranged)

    def _raw_table(self, state: FleetState) -> Table:
        if self.topic is None:
            self.topic = self.worst_topic(self.robot)
        topic = self._topic()
        if topic is None:
            return Table((), (), tr("no topic selected: press Enter on a row of Topics"))
        if Page.RAW not in self._frozen:
            bad = topic.bad
            if self.shows_bad:
                self._raw = (bad.raw, bad.text) if bad else (None, "bad")
            else:
                self._raw = topic.last, bad.text if bad and bad.raw is topic.last else ""
        return raw_table(topic, *self._raw, state.now)

    def _topic(self) -> TopicCounter | None:
        counters = self._backend.counters
        if not counters or self.topic is None:
            return None
        link, topic = self.topic
        return counters[link].topics[topic]

    def choose(self, link: str, topic: str) -> None:
        """Show the messages of this topic, live."""
        self.topic = (link, topic)
        self.shows_bad = False
        self._frozen.pop(Page.RAW, None)

    def turn_bad(self) -> None:
        """Show the last bad message, or the newest one again."""
        self.shows_bad = not self.shows_bad
        self._frozen.pop(Page.RAW, None)

    def next_level(self) -> None:
        """Show fewer levels of the robots' log, after the fewest all again."""
        least = Severity.DEBUG if self.least is Severity.FATAL else Severity(self.least + 1)
        self.least = least

    def freeze(self, page: Page) -> bool:
        """Freeze the page, or resume; False if there is nothing to freeze."""
        if page not in (Page.RAW, Page.LOG):
            return False
        if page in self._frozen:
            del self._frozen[page]
        else:
            self._frozen[page] = self._state().now
        return True

    def frozen(self, page: Page) -> str:
        """Return the text for the time since a page was frozen, empty if it is live."""
        at = self._frozen.get(page)
        return "" if at is None else tr("frozen {age} ago", age=age(self._state().now - at))

    @property
    def copied(self) -> tuple[str, str]:
        """Return the message as a text to copy, and its description; empty if there is none."""
        if self._raw[0] is None or self.topic is None:
            return "", ""
        text, size = copied(self._raw[0])
        return text, tr("the message of {topic}, {size}", topic=self.topic[1], size=size)


def line_of(key: Hashable) -> Hashable:
    """Return the key of the log line that a row is a part of."""
    return key[0] if isinstance(key, tuple) else key


def _own_facts(budget: Budget) -> OwnFacts:
    now = time.monotonic()
    pictures, sent = budget.sent.rates(now) or (0.0, 0.0)
    resident, peak = memory() or (None, None)
    return OwnFacts(
        budget.every,
        budget.ticks.spread(),
        budget.paints.spread(),
        pictures,
        sent,
        budget.held,
        resident,
        peak,
        threading.active_count(),
        age(now - budget.began),
    )
