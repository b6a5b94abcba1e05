"""Support for the scenarios: a console with short time limits, and the outcomes of its commands."""

from typing import Any

import msgspec

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import CommandRecord, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console
from tests.support.watched_store import config_of

R0 = "robot_0"
NO_ANSWER_AFTER = 0.5  # seconds, where an answer is not expected


def patient(url: str) -> Config:
    """One robot, and the seconds that an operator has."""
    return config_of(url, 1)


def hasty(url: str, not_confirmed_after: float = 5.0) -> Config:
    """The same with fewer seconds, for what is expected to fail: nothing else must fail on a busy machine."""
    config = patient(url)
    alarms = msgspec.structs.replace(
        config.alarms, no_answer_after=NO_ANSWER_AFTER, not_confirmed_after=not_confirmed_after
    )
    return msgspec.structs.replace(config, alarms=alarms)


def plant(server: RosbridgeServer, faults: str) -> None:
    play(server, parse_faults(faults, server.world.robots))


def calls(server: RosbridgeServer) -> list[str]:
    """The services that were called, by their last name."""
    return [service.rpartition("/")[2] for service, _ in server.bridge.services.calls]


def requests(server: RosbridgeServer) -> list[Any]:
    """The request ids of the orders that reached the wire."""
    return [args["request_id"] for _, args in server.bridge.services.calls if "request_id" in args]


async def ended(it: Console, count: int = 1) -> CommandRecord:
    """The last of so many commands, once all of them have ended."""

    def holds(state: FleetState) -> bool:
        return len(state.commands) == count and all(record.is_decided for record in state.commands)

    return (await it.until(holds)).commands[-1]


def stages(record: CommandRecord) -> list[Stage]:
    return [step.stage for step in record.steps]


def is_up(state: FleetState) -> bool:
    """Tell whether telemetry and commands get through."""
    return all(
        link.phase is Phase.UP and link.command_path is CommandPath.ALIVE for link in state.links.values()
    )


async def heard_anew(it: Console) -> None:
    """Wait until the link is up and the queue was heard once more."""
    now = it.store.state.now
    await it.until(is_up)
    await it.until(lambda state: (queue := state.robots[R0].queue) is not None and queue.at > now)
