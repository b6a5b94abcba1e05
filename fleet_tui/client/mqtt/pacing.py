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
        self._rates = config.rates
        self._store = store
        self._frequent = dict[str, str]()
        self._plan = RatePlan(
            config.rates.changes_per_s,
            lambda _, before, after: int(before.unseen != after.unseen),
        )
        self.extend(feeds, 0.0)

    def extend(self, feeds: Iterable[Feed], now: float) -> None:
        """Pace these topics, too, which are subscribed."""
        added = {feed.robot: feed.address for feed in feeds if feed.fast}
        self._frequent |= added
        self._plan.extend(dict.fromkeys(added, FULL), now)

    def begin(self, now: float) -> None:
        """Take the wishes for new subscriptions from the attention."""
        self._plan.begin(self._wanted(), now)

    def is_wanted(self, feed: Feed) -> bool:
        """Tell whether to subscribe to a topic."""
        return not feed.fast or not self._plan.asked.get(feed.robot, FULL).unseen

    def due(self, now: float) -> Mapping[str, bool]:
        """Return the topics to subscribe to (True) or to leave by now."""
        return {
            self._frequent[robot]: not self._plan.asked[robot].unseen
            for robot, before in self._plan.due(self._wanted(), now)
            if before.unseen != self._plan.asked[robot].unseen
        }

    def _wanted(self) -> Mapping[str, Intervals]:
        return intervals(self._store.state, self._frequent, self._store.attention, self._rates)
