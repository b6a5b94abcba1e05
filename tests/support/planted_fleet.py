"""A simulated fleet with planted faults, as the console would hear it: no wire, no clock."""

import json
from collections.abc import Callable
from itertools import count

import msgspec

from fleet_tui.adapters.adapter import ServiceCall
from fleet_tui.adapters.profile import Profile
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.messages import topics_of
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.reducer import apply
from tests.support.fleets import LINK, R0, T0, WALL, link_up, tick
from tests.support.watched_store import config_of

STEP = 0.1


class Planted:
    """The server is never started: what it would publish and answer is read by the real interpreter."""

    def __init__(
        self, faults: str = "", robots: int = 2, quiet: bool = True, tells_pause: bool = True
    ) -> None:
        self.world = World(robots, 1, seed=1, quiet=quiet)
        self.server = RosbridgeServer(self.world)
        config = config_of("ws://site:9090", robots, 1)
        if not tells_pause:
            config = msgspec.structs.replace(config, profile=Profile())
        self._adapters = adapters_of(config)
        self._wanted = {one.address: one for one in feeds_of(config, self._adapters, LINK)}
        self._topics = [one for one in topics_of(self.world, WALL) if one.name in self._wanted]
        self._ids = count(1)
        self.state: FleetState = initial_state(config, T0)
        self.now = T0
        self.tell(link_up(T0))
        self.deaf = False
        self.plant(faults)
        for topic in self._topics:
            if topic.latched and not self._wanted[topic.name].large:
                self._listen(topic.name, topic.payload(self.now).json)

    @property
    def robot(self) -> Robot:
        """The one that is asked why."""
        return self.state.robots[R0]

    def tell(self, *facts: Event) -> None:
        for fact in facts:
            self.state = apply(self.state, fact)

    def plant(self, faults: str) -> None:
        play(self.server, parse_faults(faults, self.world.robots))

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> "Planted":
        """Let time pass, up to so many seconds or until something holds."""
        for n in range(round(seconds / STEP)):
            self.now += STEP
            self.world.step(STEP)
            for topic in self._topics:
                robot = topic.robot
                silent = (
                    self.deaf
                    or topic.name in self.server.bridge.muted
                    or (robot is not None and robot.silence > 0)
                )
                if not topic.latched and not silent and (topic.fast or n % 5 == 0):
                    self._listen(topic.name, topic.payload(WALL + self.now).json)
            self.tell(tick(self.now))
            if until():
                break
        return self

    def command(self, command: Command) -> "Planted":
        """Given by the operator, and answered by the simulator as its faults have it."""
        id_ = next(self._ids)
        self.tell(CommandIssued(id_, command, self.now, WALL), CommandAdvanced(id_, Stage.SENT, self.now))
        adapter = self._adapters[command.robot]
        (call,) = adapter.outgoing(command, id_, self.state.robots[command.robot])
        assert isinstance(call, ServiceCall)
        frame = self.server.bridge.services.answer(
            {"service": call.address, "args": dict(call.args), "id": "1"}
        )
        if frame is not None:
            answer = json.loads(frame)
            stage, detail = adapter.outcome(command, answer["values"], answer["result"])
            self.tell(CommandAdvanced(id_, stage, self.now, detail))
        return self

    def _listen(self, topic: str, payload: str) -> None:
        wanted = self._wanted[topic]
        self.tell(*self._adapters[wanted.robot].read(wanted, msgspec.Raw(payload.encode()), self.now))
