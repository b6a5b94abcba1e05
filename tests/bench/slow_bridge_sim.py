"""The simulator behind a bridge that takes 20 ms for each subscription, as one of ROS 1 does.

Arguments: those of `fleet-tui sim`.
"""

import sys
from functools import partialmethod

from fleet_tui.__main__ import main as fleet_tui
from fleet_tui.simulator.server import RosbridgeServer

DELAY = 0.02


def main() -> None:
    sys.argv = ["fleet-tui", "sim", *sys.argv[1:]]
    RosbridgeServer.__init__ = partialmethod(RosbridgeServer.__init__, subscribe_delay=DELAY)  # type: ignore[assignment]  # the same with one argument more
    fleet_tui()


if __name__ == "__main__":
    main()
