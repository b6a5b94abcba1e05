"""The simulator with cameras of 640 x 480 pixels. Arguments: those of `fleet-tui sim`."""

import sys

from fleet_tui.__main__ import main as fleet_tui
from fleet_tui.simulator.senses import camera


def main() -> None:
    camera.view.__defaults__ = ((640, 480),)
    sys.argv = ["fleet-tui", "sim", *sys.argv[1:]]
    fleet_tui()


if __name__ == "__main__":
    main()
