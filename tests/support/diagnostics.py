"""Counters of a link as the diagnostics screen gets them, and its tables as text."""

from fleet_tui.model.counters import LinkCounter, TopicCounter
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.tables.diagnostics.links import Links
from fleet_tui.ui.view.tables.table import Table
from tests.support.fleets import LINK, R0, T0, fleet, link_up, reduced, tick

POSE, GRAPH, MAP, BATTERY = "/robot_0/pose", "/robot_0/f/graph", "/robot_0/f/map", "/robot_0/battery"


NOW = T0 + 20.0


def counter() -> LinkCounter:
    topics = [
        TopicCounter(BATTERY, R0, "battery"),
        TopicCounter(POSE, R0, "pose"),
        TopicCounter("/robot_1/pose", "robot_1", "pose"),
        TopicCounter(GRAPH, R0, "graph", once=True),
        TopicCounter(MAP, R0, "map", once=True, on_demand=True),
        TopicCounter("/rosout"),
    ]
    return LinkCounter(LINK, topics)


def seen(link: LinkCounter, state: FleetState | None = None) -> tuple[FleetState, Links]:
    state = reduced(state or reduced(fleet(2), link_up(T0)), tick(NOW))
    return state, [(state.links[LINK], link)]


def text(table: Table) -> list[str]:
    title = "".join(part for part, _ in table.title)
    return [title, *("".join(part for part, _ in row.runs).rstrip() for row in table.rows)]


def row(table: Table, word: str) -> str:
    (found,) = (line for line in text(table)[1:] if word in line)
    return found


def steady(topic: TopicCounter, until: float = NOW, rate: float = 10.0) -> None:
    for n in range(100):
        topic.count_frame(b"x" * 200, False, until - (99 - n) / rate)
