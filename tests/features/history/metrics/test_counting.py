"""Events since the start, each counted once."""

from msgspec.structs import replace
from prometheus_client import CollectorRegistry

from fleet_tui.features.history.metrics.counting import Counting
from tests.support.fleets import T0, queue, reduced, tick
from tests.support.records import known_fleet, record


def test_orders_by_their_end() -> None:
    registry = CollectorRegistry()
    counting = Counting(registry)
    state = reduced(known_fleet(), queue(T0 + 1, (7, 1, 2, "W")), tick(T0 + 1))
    counting.observe(state)
    gone = reduced(state, queue(T0 + 2), tick(T0 + 2))
    for seen in (gone, gone):
        counting.observe(seen)
    ended = {
        outcome: registry.get_sample_value("fleet_orders_total", {"robot": "robot_0", "outcome": outcome})
        for outcome in ("done", "lost", "failed", "cancelled")
    }
    assert ended == {"done": 0.0, "lost": 1.0, "failed": 0.0, "cancelled": None}


def test_steps_of_commands_to_robots_of_this_fleet() -> None:
    registry = CollectorRegistry()
    counting = Counting(registry)
    others = [record(robot="another"), replace(record(), demo=True), record(kind="console", robot="")]
    counting.read(known_fleet(), [record(), record(), record(change="refused"), *others])

    def count(stage: str) -> float | None:
        labels = {"command": "pause", "stage": stage}
        return registry.get_sample_value("fleet_commands_total", labels)

    assert (count("sent"), count("refused"), count("confirmed")) == (2.0, 1.0, None)
