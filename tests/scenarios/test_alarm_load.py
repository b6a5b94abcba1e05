"""The number of alarms of a fleet without faults: ISA-18.2 asks for about one in ten minutes."""

from collections import Counter
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.console.demo import demo_config
from fleet_tui.model.alarm import AlarmStage, Key, transitions
from fleet_tui.model.events import LinkChanged, MessageArrived, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.state.store import Store

pytestmark = pytest.mark.nightly

TICK = 0.5
"""Seconds between two looks at the fleet: pose, queue and the rest come that often."""


def raised(world: OhFleet, minutes: float, folder: Path) -> tuple[Counter[Key], Store]:
    """Every alarm of so many minutes of a world's time, through adapter and reducer, without a network."""
    fleet = world
    floors = len(world.building.floors)
    config = demo_config(Config(), "ws://nowhere:1", len(world.robots), floors, folder=folder)
    adapters, topics = adapters_of(config), {topic.name: topic for topic in fleet.topics(0.0, ROS1)}
    feeds = [
        (topics[feed.address], robot, feed._replace(robots=(robot,)))
        for feed in feeds_of(config, adapters, DEFAULT_LINK)
        for robot in feed.robots
        if not feed.large and not feed.on_demand
    ]
    store, found = Store(initial_state(config, 0.0)), Counter[Key]()

    def watch(before: FleetState, after: FleetState) -> None:
        for change in transitions(before.alarms, after.alarms, after.wall):
            found[change.alarm.key] += change.now is AlarmStage.UNACKNOWLEDGED

    store.watchers.append(watch)
    store.apply(LinkChanged(DEFAULT_LINK, 0.0, Phase.UP))
    for n in range(round(minutes * 60 / TICK)):
        now = n * TICK
        fleet.step(TICK)
        for topic, robot, feed in feeds:
            if (topic.latched and n) or (topic.robot is not None and topic.robot.silence > 0.0):
                continue
            said = msgspec.Raw(topic.payload(now).json.encode())
            for event in adapters[robot].read(feed, said, now):
                store.apply(event)
        store.apply(MessageArrived(DEFAULT_LINK, now))
        store.apply(TimePassed(now, now))
    return found, store


@pytest.mark.parametrize("seed", [0, 1])
def test_a_fleet_without_faults_raises_hardly_any_alarm(seed: int, tmp_path: Path) -> None:
    found, _ = raised(OhFleet(robots=12, floors=2, seed=seed), 30, tmp_path)
    assert found.total() <= 3, found


def test_one_stuck_robot_is_the_one_alarm(tmp_path: Path) -> None:
    world = OhFleet(robots=12, floors=2, seed=0)
    world.robots["robot_4"].stuck = True
    found, store = raised(world, 6, tmp_path)
    assert list(found) == [("robot_4", "stuck")]
    assert [alarm.key for alarm in store.state.alarms] == [("robot_4", "stuck")]
