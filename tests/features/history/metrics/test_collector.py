"""The gauges of a fleet: what is known now, and nothing else."""

import time

import pytest
from prometheus_client import CollectorRegistry, generate_latest
from prometheus_client.parser import text_string_to_metric_families

from fleet_tui.features.history.metrics.collector import FleetCollector
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import R0, battery, fleet, link_lost, link_up, pose, queue, reduced, tick

NOW = 5000.0
Samples = dict[tuple[str, ...], float]


@pytest.fixture(autouse=True)
def clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(time, "monotonic", lambda: NOW)


def scraped(state: FleetState, **counters: LinkCounter) -> dict[str, Samples]:
    """The samples of each gauge by the values of their labels."""
    registry = CollectorRegistry()
    registry.register(FleetCollector(lambda: state, lambda: counters))
    found: dict[str, Samples] = {}
    for family in text_string_to_metric_families(generate_latest(registry).decode()):
        for sample in family.samples:
            found.setdefault(sample.name, {})[tuple(sample.labels.values())] = sample.value
    return found


def test_a_robot_that_reports() -> None:
    state = reduced(
        fleet(2), link_up(NOW - 9), pose(NOW - 1), battery(NOW - 1, 40.0),
        queue(NOW - 1, (7, 1, 2, "Q"), (8, 2, 1, "Q")), tick(NOW),
    )  # fmt: skip
    told = scraped(state)
    assert set(told["fleet_robot_online"].values()) == {0.0, 1.0}
    assert told["fleet_robot_battery_ratio"] == {(R0,): 0.4}
    assert told["fleet_robot_message_age_seconds"] == {(R0,): 1.0}
    assert told["fleet_robot_orders"] == {(R0, "queued"): 2.0}
    does = {key for key, value in told["fleet_robot_activity"].items() if value}
    assert {does_ for does_ in does if "robot_1" in does_} == {("offline", "robot_1")}
    assert len(does) == 2
    assert told["fleet_link_up"] == {("rosbridge",): 1.0} and told["fleet_state_age_seconds"] == {(): 0.0}


def test_what_is_old_has_no_sample() -> None:
    state = reduced(fleet(), link_up(NOW - 90), pose(NOW - 60), battery(NOW - 60, 40.0),
                    queue(NOW - 60, (7, 1, 2, "W")), link_lost(NOW - 30), tick(NOW))  # fmt: skip
    told = scraped(state)
    assert "fleet_robot_battery_ratio" not in told and "fleet_robot_orders" not in told
    assert told["fleet_robot_message_age_seconds"] == {(R0,): 60.0}
    assert told["fleet_link_up"] == {("rosbridge",): 0.0}
    assert list(told["fleet_alarms"].values()) == [1.0]


def test_a_state_that_nobody_advances_says_its_age() -> None:
    told = scraped(reduced(fleet(), tick(NOW - 12)))
    assert told["fleet_state_age_seconds"] == {(): 12.0}


def test_the_round_trip_is_the_last_one() -> None:
    counter = LinkCounter("rosbridge", ())
    up = reduced(fleet(), link_up(NOW - 9), tick(NOW))
    assert "fleet_link_round_trip_seconds" not in scraped(up, rosbridge=counter)
    for seconds in (0.5, 0.25):
        counter.round_trips.take(seconds, NOW)
    told = scraped(up, rosbridge=counter)
    assert told["fleet_link_round_trip_seconds"] == {("rosbridge",): 0.25}


def test_a_lost_link_tells_nothing_of_itself_or_its_robots_as_if_it_were_up() -> None:
    counter = LinkCounter("rosbridge", ())
    counter.round_trips.take(0.5, NOW)
    lost = reduced(fleet(), link_up(NOW - 90), pose(NOW - 60), link_lost(NOW - 30), tick(NOW))
    told = scraped(lost, rosbridge=counter)
    for name in ("fleet_link_round_trip_seconds", "fleet_link_late_seconds", "fleet_robot_activity"):
        assert name not in told
    assert list(told["fleet_robot_online"].values()) == [0.0]
