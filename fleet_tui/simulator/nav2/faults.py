"""What can go wrong with robots with Nav2."""

from collections.abc import Mapping

from fleet_tui.simulator.faults import wire

FAULTS: Mapping[str, tuple[str, wire.Play]] = {}
