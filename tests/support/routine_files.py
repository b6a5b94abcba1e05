"""Routine files beside a configuration, and robots that drive them fast."""

from pathlib import Path

from fleet_tui.simulator.server import RosbridgeServer

ONE_ROBOT = '[[floors]]\nname = "f"\n[[robots]]\nname = "robot_0"\n'
"""A configuration."""


def routine(folder: Path, text: str, name: str = "day") -> None:
    """Write a routine beside the configuration of a folder."""
    (folder / "routines").mkdir(exist_ok=True)
    (folder / "routines" / f"{name}.routine").write_text(text)


def hurry(server: RosbridgeServer) -> None:
    """Let the robots drive many times as fast."""

    def step(_dt: float) -> None:
        for robot in server.world.robots.values():
            for _ in range(9 * bool(robot.orders)):
                robot.step()

    server.world.troubles.append(step)
