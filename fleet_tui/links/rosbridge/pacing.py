"""Pacing of one bridge's topics: each is subscribed at an interval by the operator's attention."""

from collections.abc import Iterable, Mapping

from fleet_tui.config.schema import Config
from fleet_tui.links.rates.plan import RatePlan
from fleet_tui.links.rates.wanted import FULL, by_attention, intervals, is_large
from fleet_tui.model.attention import Intervals
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.state.store import Store

SHARE = 0.4
"""Share of the silence after which a value is old that two of its messages may be apart: one may get lost."""


def is_paced(feed: Feed) -> bool:
    """Tell whether only the newest message of a topic counts, it comes regularly, and it is of one robot."""
    is_regular = not (feed.latched or feed.on_demand or feed.silent)
    return is_regular and not feed.is_shared and len(feed.robots) == 1 and feed.queue_length == 1


class Pacing:
    """Runs on the network loop."""

    def __init__(
        self, config: Config, adapters: Mapping[str, Adapter], feeds: Iterable[Feed], store: Store
    ) -> None:
        """`adapters` by robot."""
        self._rates = config.rates
        self._adapters = adapters
        self._store = store
        self._usual_silence = config.alarms.offline_after
        self._confirmed_within = config.alarms.not_confirmed_after
        self._paced: dict[str, list[Feed]] = {}
        for feed in filter(is_paced, feeds):
            self._paced.setdefault(feed.robot, []).append(feed)
        self._is_large = is_large(store.state, config.rates)
        self._plan = RatePlan(config.rates.changes_per_s, lambda *change: len(self._changed(*change)))

    def begin(self, now: float) -> None:
        """Take the intervals for new subscriptions from the attention at a monotonic second."""
        self._plan.begin(self._wanted(), now)

    def due(self, now: float) -> list[Feed]:
        """Return the topics to subscribe again at another interval."""
        if not self._is_large:
            return []
        changed = self._plan.due(self._wanted(), now)
        return [
            feed for name, before in changed for feed in self._changed(name, before, self._plan.asked[name])
        ]

    def interval(self, feed: Feed) -> int:
        """Return the milliseconds between two messages of a topic."""
        if feed.wanted_for == "place":
            return 0  # a bridge that throttles a topic drops all messages but those of one publisher
        if not is_paced(feed):
            return feed.rate_ms
        return self._interval(feed, self._plan.asked.get(feed.robot, FULL))

    def sorted(self, feeds: Iterable[Feed]) -> list[Feed]:
        """Return topics in the order of attention."""
        places = by_attention(self._store.state, self._store.attention)
        return sorted(feeds, key=lambda feed: min(places[robot] for robot in feed.robots))

    def _wanted(self) -> Mapping[str, Intervals]:
        return intervals(self._store.state, self._paced, self._store.attention, self._rates)

    def _changed(self, robot: str, before: Intervals, after: Intervals) -> list[Feed]:
        return [
            feed for feed in self._paced[robot] if self._interval(feed, before) != self._interval(feed, after)
        ]

    def _interval(self, feed: Feed, asked: Intervals) -> int:
        """Return an interval that leaves time to notice that messages have ceased, and the effect of a
        command."""
        kind, usual = self._adapters[feed.robot].kind, self._usual_silence
        silence = min(kind.silence_of(feed.key, usual), kind.offline_after or usual, self._confirmed_within)
        wanted = asked.pose if feed.fast else asked.status
        return max(feed.rate_ms, int(min(wanted, silence * 1000 * SHARE)))
