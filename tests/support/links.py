"""The whole link without a screen, for tests against a real loopback server."""

import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from fleet_tui.cli.session import opened
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.queue_file import QueueFile
from fleet_tui.links.tap import Tap
from fleet_tui.model.commands import Command, CommandRecord
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from tests.support.watched_store import WatchedStore


@asynccontextmanager
async def linked(
    config: Config, tap: Tap | None = None, queue: QueueFile | None = None
) -> AsyncIterator[tuple[FleetLink, WatchedStore]]:
    store = WatchedStore(initial_state(config, time.monotonic()))
    with opened(FleetLink(config, store, tap, queue), config) as link:
        yield link, store


def phase(wanted: Phase) -> Callable[[FleetState], bool]:
    return lambda state: state.links["rosbridge"].phase is wanted


def path(wanted: CommandPath) -> Callable[[FleetState], bool]:
    return lambda state: state.links["rosbridge"].command_path is wanted


def ready(state: FleetState) -> bool:
    """All telemetry has come and commands get through."""
    readings = [
        (robot.pose, robot.queue, robot.battery, robot.cargo, robot.obstacle, robot.paused)
        for robot in state.robots.values()
    ]
    maps = [robot_map for robot in state.robots.values() for robot_map in robot.maps.values()]
    received = all(None not in reading for reading in readings)
    known = all(robot_map.graph and robot_map.frame and robot_map.labels for robot_map in maps)
    return received and known and path(CommandPath.ALIVE)(state)


async def finished(link: FleetLink, store: WatchedStore, command: Command) -> CommandRecord:
    command_id = link.submit(command)
    state = await store.until(
        lambda state: any(record.id == command_id and record.is_decided for record in state.commands)
    )
    return next(record for record in state.commands if record.id == command_id)
