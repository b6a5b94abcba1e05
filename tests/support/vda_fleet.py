"""One vehicle `agv` (KIT, 0001) of a configuration, its reader and its state, for tests without a broker."""

from functools import reduce
from typing import cast

from fleet_tui.config.fleet import adapters_of, feeds_of, limit_of
from fleet_tui.config.load import from_text
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.robot import Robot
from fleet_tui.robots.vda5050.adapter import VehicleAdapter
from fleet_tui.robots.vda5050.broker_reader import MessageReader
from fleet_tui.robots.vda5050.frames import BrokerMessage
from fleet_tui.state.reducer import apply
from tests.support.vda_messages import BASE

T0 = 1000.0
ONE = '[[robots]]\nname = "agv"\nmanufacturer = "KIT"\nserial = "0001"\nlink = "broker"'
AGV = "agv"


def config_text(
    url: str = "mqtt://127.0.0.1:1", role: str = "master", settings: str = "", robots: str = ONE
) -> str:
    return f"""
[links.broker]
url = "{url}"
role = "{role}"
[[floors]]
name = "hall"
[profile]
kind = "vda5050"
[profile.vda5050]
{settings}
{robots}
"""


class VehicleSite:
    """The state of a site after messages, as a link would have it."""

    def __init__(self, config: Config | None = None) -> None:
        self.config = config or from_text(config_text())
        adapters = adapters_of(self.config)
        self.adapter = cast("VehicleAdapter", adapters[AGV])
        feeds = feeds_of(self.config, adapters, "broker")
        self.reader = MessageReader("broker", limit_of(self.config, "broker"), adapters, feeds)
        self.state: FleetState = initial_state(self.config, T0)
        self.now = T0
        self.apply(events.LinkChanged("broker", T0, Phase.UP), events.TimePassed(T0, T0))

    def apply(self, *found: events.Event) -> None:
        self.state = reduce(apply, found, self.state)

    def read(
        self, name: str, payload: bytes, kept: bool = False, base: str = BASE
    ) -> tuple[events.Event, ...]:
        found = self.reader.read_message(BrokerMessage(f"{base}/{name}", payload, kept), self.now)
        self.apply(*found)
        return found

    def wait(self, seconds: float) -> None:
        self.now += seconds
        self.apply(events.TimePassed(self.now, self.now))

    @property
    def agv(self) -> Robot:
        return self.state.robots[AGV]

    @property
    def alarms(self) -> dict[str, str]:
        return {alarm.condition.kind: alarm.text for alarm in self.state.alarms if alarm.holds}
