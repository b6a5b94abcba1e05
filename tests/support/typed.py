"""A fleet whose places have names that are hard to type."""

from fleet_tui.model.fleet import FleetState
from tests.support.fleets import R0, fleet, graph, labels, queue, told

NAMED = {1: "Base", 2: "Consumidores", 3: "Dock 7", 4: "Lab > base", 5: "Joe's", 6: "x-"}


R1 = "robot_1"


def known(named: dict[int, str] | None = None) -> FleetState:
    ids = sorted({*range(1, 10), *(named or ())})
    facts = (graph(*ids, robot=name) for name in (R0, R1))
    detail = (labels(named or NAMED, robot=name) for name in (R0, R1))
    return told(fleet(2), *facts, *detail, queue(1000.0, (12, 1, 2, "W"), (13, 2, 1, "Q")))
