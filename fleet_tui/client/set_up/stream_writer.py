"""Values of streams, from the wire to their store: scans placed on their robots, stamps as our time."""

from typing import TYPE_CHECKING

from fleet_tui.state.store import Store

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import LaserScan, PlannedPath


class StreamWriter:
    """Writes the streams of one bridge. On the network loop."""

    def __init__(self, store: Store) -> None:
        self._store, self.wants, self._put = store, store.streams.wants, store.streams.put

    def put(self, robot: str, key: str, value: "LaserScan | PlannedPath", at: float) -> None:
        """Keep a value that arrived at a monotonic second."""
        # With numpy, which a value of a stream has imported already.
        from fleet_tui.model.set_up.streams import LaserScan, Streamed, beams_of

        known = self._store.state.robots.get(robot)
        if known is None:
            return
        taken_at = at
        if value.stamp is not None and known.clock is not None:
            taken_at = min(at, value.stamp + known.clock.offset)
        if isinstance(value, LaserScan):
            self._put(robot, key, Streamed(beams_of(value, known.laser, known.laser_flipped), at, taken_at))
        else:
            self._put(robot, key, Streamed(value, at, taken_at))
