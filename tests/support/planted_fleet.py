"""A simulated fleet with planted faults, as the console would hear it: no wire, no clock."""

import json
import threading
from collections.abc import Callable
from itertools import count

import msgspec

from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued, Event, MessageArrived, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.oh_ressources.messages import topics_of
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.store import Store
from tests.support.fleets import LINK, R0, T0, WALL, link_up
from tests.support.watched_store import config_of

STEP = 0.1
MAPS = dict[tuple[str, str], list[Event]]()
"""What was read from a topic and text: the same map for each test takes long to read."""


class Planted:
    """The server is never started: what it would publish and answer is read by the real interpreter."""

    def __init__(
        self,
        faults: str = "",
        robots: int = 2,
        quiet: bool = True,
        tells_pause: bool = True,
        config: Config | None = None,
        store: Store | None = None,
        at: float = T0,
        wall: float = WALL,
    ) -> None:
        """`at` is the monotonic time, `wall` the time since 1970 at 0. A `config` has its own robots."""
        config = config or config_of("ws://site:9090", robots, 1)
        if not tells_pause:
            config = msgspec.structs.replace(config, profile=Profile())
        self.world = OhFleet(len(config.robots), len(config.floors), seed=1, quiet=quiet)
        self.server = RosbridgeServer(self.world)
        self.store = store or Store(initial_state(config, at))
        self._adapters = adapters_of(config)
        self._wanted = {one.address: one for one in feeds_of(config, self._adapters, LINK)}
        self._topics = [one for one in topics_of(self.world, WALL) if one.name in self._wanted]
        self._ids = count(1)
        self._steps = count()
        self._unanswered = list[tuple[int, Command]]()
        self._changing = threading.RLock()
        """Commands may come from any thread."""
        self.now, self._wall = at, wall
        self.tell(link_up(at))
        self.deaf = False
        self.plant(faults)
        for topic in self._topics:
            if topic.latched and not self._wanted[topic.name].large:
                self.hear(topic.name, topic.payload(self.now).json)

    @property
    def state(self) -> FleetState:
        return self.store.state

    @property
    def robot(self) -> Robot:
        """The one that is asked why."""
        return self.state.robots[R0]

    def tell(self, *facts: Event) -> None:
        with self._changing:
            for fact in facts:
                self.store.apply(fact)

    def plant(self, faults: str) -> None:
        play(self.server, parse_faults(faults, self.world.robots))

    def run(self, seconds: float, until: Callable[[], bool] = lambda: False) -> "Planted":
        """Let time pass, up to so many seconds or until something holds."""
        for _ in range(round(seconds / STEP)):
            self.now += STEP
            self.world.step(STEP)
            self.answer()
            turn = next(self._steps) % 5 == 0
            for topic in self._topics:
                robot = topic.robot
                silent = (
                    self.deaf
                    or topic.name in self.server.bridge.muted
                    or (robot is not None and robot.silence > 0)
                )
                if not topic.latched and not silent and (topic.fast or turn):
                    self.hear(topic.name, topic.payload(self._wall + self.now).json)
            if not self.deaf:
                self.tell(MessageArrived(LINK, self.now))
            self.tell(TimePassed(self.now, self._wall + self.now))
            if until():
                break
        return self

    def command(self, command: Command) -> "Planted":
        """Given by the operator, and answered by the simulator as its faults have it."""
        self.give(command)
        self.answer()
        return self

    def give(self, *commands: Command) -> None:
        """Given by the operator, and on their way to the robots."""
        given = [(next(self._ids), command) for command in commands]
        with self._changing:
            with self.store.together():
                for id_, command in given:
                    self.tell(CommandIssued(id_, command, self.now, self._wall + self.now))
            for id_, _ in given:
                self.tell(CommandAdvanced(id_, Stage.SENT, self.now))
            self._unanswered += given

    def answer(self) -> None:
        """Let the simulator answer what has been given."""
        with self._changing:
            given, self._unanswered = self._unanswered, []
        for id_, command in given:
            adapter = self._adapters[command.robot]
            for call in adapter.outgoing(command, id_, self.state.robots[command.robot]):
                assert isinstance(call, ServiceCall)
                frame = self.server.bridge.services.answer(
                    {"service": call.address, "args": dict(call.args), "id": "1"}
                )
                if frame is not None:
                    answer = json.loads(frame)
                    stage, detail = adapter.outcome(command, answer["values"], answer["result"])
                    self.tell(CommandAdvanced(id_, stage, self.now, detail))

    def show_map(self, robot: str, floor: str) -> None:
        """Hear the map that is on screen now."""
        for topic in self._topics:
            feed = self._wanted[topic.name]
            if feed.wanted_for == "map" and (feed.robot, feed.floor) == (robot, floor):
                text = topic.payload(self.now).json
                if (topic.name, text) not in MAPS:
                    MAPS[topic.name, text] = self._read(topic.name, text)
                self.tell(*MAPS[topic.name, text])

    def hear(self, topic: str, payload: str) -> None:
        """Hear a message of a topic, as JSON."""
        self.tell(*self._read(topic, payload))

    def _read(self, topic: str, payload: str) -> list[Event]:
        wanted = self._wanted[topic]
        return list(self._adapters[wanted.robot].read(wanted, msgspec.Raw(payload.encode()), self.now))
