"""Pacing of vehicles: a broker has no rates, so the frequent positions of those that nobody looks at are not
subscribed. Their states tell the position, too, less often."""

from collections.abc import Iterable, Mapping

from fleet_tui.adapters.adapter import Feed
from fleet_tui.config.schema import Config
from fleet_tui.rules.rates.attention import Intervals
from fleet_tui.rules.rates.plan import RatePlan
from fleet_tui.rules.rates.wanted import FULL, intervals
from fleet_tui.state.store import Store


class VehiclePacing:
    """Runs on the network loop. Times are monotonic seconds."""

    def __init__(self, config: Config, feeds: Iterable[Feed], store: Store) -> None:
        self._rates, self._store = config.rates, store
        self._frequent = {feed.robot: feed.address for feed in feeds if feed.fast}
        self._plan = RatePlan(
            config.rates.changes_per_s,
            lambda _, before, after: int(self._is_frequent(before) != self._is_frequent(after)),
        )

    def begin(self, now: float) -> None:
        """Take the wishes for new subscriptions from the attention."""
        self._plan.begin(self._wanted(), now)

    def is_wanted(self, feed: Feed) -> bool:
        """Tell whether to subscribe to a topic."""
        return not feed.fast or self._is_frequent(self._plan.asked.get(feed.robot, FULL))

    def due(self, now: float) -> Mapping[str, bool]:
        """Return the topics to subscribe to (True) or to leave by now."""
        return {
            self._frequent[robot]: self._is_frequent(self._plan.asked[robot])
            for robot, before in self._plan.due(self._wanted(), now)
            if self._is_frequent(before) != self._is_frequent(self._plan.asked[robot])
        }

    def _wanted(self) -> Mapping[str, Intervals]:
        return intervals(self._store.state, self._frequent, self._store.attention, self._rates)

    def _is_frequent(self, asked: Intervals) -> bool:
        return asked == FULL or asked.pose < self._rates.pose_ms
