"""Simulated robots with move_base as a value that steps: no I/O; the seed is the only chance in it."""

from fleet_tui.simulator.move_base.navigation import MoveBase
from fleet_tui.simulator.navigating.world import Clock, NavigatingWorld


class MoveBaseWorld(NavigatingWorld[MoveBase]):
    """`robots` robots on `floors` floors, as NavigatingWorld has it."""

    def __init__(
        self,
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        clock: Clock | None = None,
    ) -> None:
        super().__init__(MoveBase, robots, floors, seed, quiet, first, clock)
