"""The fleet at the moment of a scrape, as Prometheus gauges. docs/metrics.md lists them."""

import math
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TypeVar

from prometheus_client.core import GaugeMetricFamily, InfoMetricFamily
from prometheus_client.metrics_core import Metric
from prometheus_client.registry import Collector

from fleet_tui import __version__
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.model.robot import Robot
from fleet_tui.situation.activity import activity

Labels = TypeVar("Labels", bound=tuple[str, ...])
Counters = Callable[[], Mapping[str, LinkCounter]]


class FleetCollector(Collector):
    """Answers each scrape from the newest state. A value that is unknown or old has no sample: nothing old is
    told as new."""

    def __init__(self, state: Callable[[], FleetState], counters: Counters) -> None:
        self._state = state
        self._counters = counters

    def describe(self) -> list[Metric]:
        """Return nothing: at its registration nothing is connected yet."""
        return []

    def collect(self) -> Iterator[Metric]:
        """Return every gauge."""
        state = self._state()
        yield InfoMetricFamily("fleet_tui", "The program that watches", value={"version": __version__})
        yield _gauge(
            "fleet_state_age_seconds", "Age of these figures", {(): time.monotonic() - state.now}, ()
        )
        yield from _robots(state)
        yield from _links(state, self._counters())
        yield _alarms(state)


def _robots(state: FleetState) -> Iterator[Metric]:
    robots = list(state.robots.values())
    online = {(one.name, one.kind.name, one.link): float(state.is_online(one)) for one in robots}
    text = "1 if its last message is young enough, else 0"
    yield _gauge("fleet_robot_online", text, online, ("robot", "kind", "link"))
    battery = {(one.name,): value / 100 for one in robots if (value := _battery(state, one)) is not None}
    yield _gauge("fleet_robot_battery_ratio", "Battery, 1 is full", battery, ("robot",))
    ages = {(one.name,): state.now - one.last_received for one in robots if one.last_received is not None}
    text = "Seconds since its last message"
    yield _gauge("fleet_robot_message_age_seconds", text, ages, ("robot",))
    does = {
        (one.name, each.value): float(each is now)
        for one in robots
        if state.links[one.link].phase is Phase.UP  # else unknown
        for now in [activity(state, one)]
        for each in Activity
    }
    yield _gauge("fleet_robot_activity", "1 for what it does, else 0", does, ("robot", "activity"))
    orders = Counter(
        (robot.name, order.state_text)
        for robot in robots
        if state.is_fresh(robot, "queue")
        for order in robot.orders.open
    )
    yield _gauge("fleet_robot_orders", "Orders in its queue by state", orders, ("robot", "state"))


def _battery(state: FleetState, robot: Robot) -> float | None:
    return robot.battery.value if robot.battery and state.is_fresh(robot, "battery") else None


def _links(state: FleetState, counters: Mapping[str, LinkCounter]) -> Iterator[Metric]:
    links = list(state.links.values())
    up = {(one.name,): float(one.phase is Phase.UP) for one in links}
    yield _gauge("fleet_link_up", "1 if the bridge is connected, else 0", up, ("link",))
    tried = [one for one in links if one.command_path is not CommandPath.UNTRIED]
    path = {(one.name,): float(one.command_path is CommandPath.ALIVE) for one in tried}
    text = "1 if commands reach the robots, else 0; none before it was tried"
    yield _gauge("fleet_link_commands", text, path, ("link",))
    text = "Seconds since its last message"
    yield _gauge("fleet_link_message_age_seconds", text, _ages(links), ("link",))
    connected = {one.name for one in links if one.phase is Phase.UP}
    late = {(one.name,): one.late for one in links if one.name in connected}
    yield _gauge("fleet_link_late_seconds", "Seconds by which its messages are late", late, ("link",))
    trips = {
        (name,): counter.round_trips.took[-1]
        for name, counter in counters.items()
        if name in connected and counter.round_trips.took
    }
    yield _gauge("fleet_link_round_trip_seconds", "The last round trip of a call", trips, ("link",))


def _ages(parts: Sequence[Robot] | Sequence[LinkState]) -> dict[tuple[str], float]:
    now = time.monotonic()
    return {(one.name,): max(0.0, now - at) for one in parts if (at := one.last_received) is not None}


def _alarms(state: FleetState) -> Metric:
    held = Counter(
        (alarm.condition.kind, alarm.condition.priority.name.lower()) for alarm in state.alarms if alarm.holds
    )
    return _gauge("fleet_alarms", "Alarms that hold, by class", held, ("alarm", "priority"))


def _gauge(
    name: str, text: str, values: Mapping[Labels, float], labels: tuple[str, ...]
) -> GaugeMetricFamily:
    gauge = GaugeMetricFamily(name, text, labels=labels)
    for of, value in values.items():
        if math.isfinite(value):
            gauge.add_metric(of, value)
    return gauge
