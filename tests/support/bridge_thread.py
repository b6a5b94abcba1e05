"""A rosbridge server on a loop of its own, for tests that drive a process by its terminal."""

import asyncio
import threading
from collections.abc import Callable, Coroutine
from typing import Any, TypeVar

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.server import RosbridgeServer

Result = TypeVar("Result")


class BridgeThread:
    """Quiet robots on two floors, and what reached them."""

    def __init__(self, robots: int = 2) -> None:
        self._loop = asyncio.new_event_loop()
        threading.Thread(target=self._loop.run_forever, daemon=True).start()
        self.server = RosbridgeServer(OhFleet(robots=robots, floors=2, seed=1, quiet=True))
        self._run(self.server.start())

    def _run(self, work: Coroutine[Any, Any, Result]) -> Result:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(30)

    def close(self) -> None:
        self._run(self.server.stop())
        self._loop.call_soon_threadsafe(self._loop.stop)

    def do(self, work: Callable[[RosbridgeServer], Result]) -> Result:
        """Do something with the server on its own loop."""

        async def on_loop() -> Result:
            return work(self.server)

        return self._run(on_loop())

    def robot(self, number: int = 0) -> SimRobot:
        return self.server.world.robots[f"robot_{number}"]

    def calls(self) -> list[str]:
        """The calls that arrived: robot, service by its last name, and the ids in it."""
        return self.do(lambda server: [_text(*call) for call in server.bridge.services.calls])

    def forget(self) -> None:
        self.do(lambda server: server.bridge.services.calls.clear())

    def rest(self) -> None:
        """Robots without orders, cargo and pauses, and no calls."""

        def clear(server: RosbridgeServer) -> None:
            for robot in server.world.robots.values():
                robot.drop({order.id for order in robot.orders})
                robot.cargo = robot.paused = False
            server.bridge.services.calls.clear()

        self.do(clear)

    def id_of(self, label: str, floor: int = 0) -> int:
        labels = self.server.world.building.floors[floor].labels
        return next(id_ for id_, name in labels.items() if name == label)

    def publish(self, topic: str, message: dict[str, Any]) -> None:
        assert self.do(lambda server: server.bridge.publish_raw(topic, message))


def _text(service: str, args: dict[str, Any]) -> str:
    robot, _, verb = service.strip("/").partition("/")
    ids = [str(args[key]) for key in ("initial_point", "end_point", "ind") if key in args]
    return " ".join([robot, verb.rpartition("/")[2], *ids])
