"""Labels, statuses and reasons come from robots: no row may be bent by them."""

from collections.abc import Iterable

import pytest
from hypothesis import example, given

from fleet_tui.model import events
from fleet_tui.model.commands import CancelOrder, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.link import CommandPath
from fleet_tui.model.order import Order, OrderQueue, Stop, at_vertices
from fleet_tui.text.language import EMPTY, verbatim
from fleet_tui.ui.view.lines.commands import message_line
from fleet_tui.ui.view.lines.status import status_line
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.tables.alarms import alarm_table
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.queue import CANCEL, queue_table
from fleet_tui.ui.view.tables.table import Row, Run, Table, cut, width_of
from tests.support.fleets import (
    F0,
    LINK,
    R0,
    T0,
    WALL,
    fleet,
    graph,
    labels,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.hostile_text import HOSTILE, TEXTS, WIDTHS, harmless


def facts(text: str) -> list[events.Event]:
    """A fleet whose robots, bridge and answers say `text` wherever they can."""
    return [
        graph(1, 2),
        labels({1: text, 2: text[::-1]}),
        pose(T0, frame=text),
        queue(T0, (4, 1, 2, text), (5, 2, 99, text), current=4),
        events.MessageRejected(R0, verbatim(text)),
        events.FrameRejected(LINK, text),
        events.CommandIssued(1, place_order(R0, 1, 2), T0, WALL),
        events.CommandIssued(2, CancelOrder(R0, "4"), T0, WALL),
        events.CommandAdvanced(1, Stage.SENT, T0),
        events.CommandAdvanced(1, Stage.REFUSED, T0, verbatim(text)),
        *other_ids(text),
    ]


def other_ids(text: str) -> list[events.Event]:
    """A robot of another stack, whose ids are text and whose orders go anywhere."""
    stops = at_vertices(text, "99"), (Stop(pose=Pose(1.0, 2.0)),), ()
    orders = tuple(Order(text + str(n), one, None, text, n) for n, one in enumerate(stops))
    return [
        graph(text, "2", robot="robot_1"),
        events.QueueReported("robot_1", T0, OrderQueue(3, text + "1", orders)),
        events.CommandIssued(3, PlaceOrder("robot_1", stops[0]), T0, WALL),
        events.CommandIssued(4, PlaceOrder("robot_1", stops[1]), T0, WALL),
        events.CommandIssued(5, CancelOrder("robot_1", text), T0, WALL),
    ]


def states(text: str) -> Iterable[FleetState]:
    known = reduced(fleet(2), link_up(T0), *facts(text), tick(T0))
    yield known
    yield reduced(known, events.CommandPathChanged(LINK, CommandPath.DEAD, verbatim(text)), tick(T0 + 1))
    yield reduced(known, link_lost(T0, text), tick(T0 + 60))


def tables(state: FleetState) -> Iterable[Table]:
    yield fleet_table(state, R0, 60)
    yield alarm_table(state, lambda wall: f"{wall:.0f}")
    yield from (queue_table(state, R0, everybody, width) for everybody in (False, True) for width in WIDTHS)


def lines(state: FleetState) -> Iterable[tuple[Run, ...]]:
    yield status_line(state, R0)
    yield message_line(state, EMPTY, 0.0, 120)
    for table in tables(state):
        yield table.title
        yield from (row.runs for row in table.rows)


@pytest.mark.parametrize("text", HOSTILE, ids=ascii)
def test_nothing_hostile_reaches_a_row(text: str) -> None:
    for state in states(text):
        for runs in lines(state):
            assert all(harmless(part) for part, _ in runs)
            for width in WIDTHS:
                assert width_of(cut(runs, width)) == width


@given(TEXTS)
@example("\u0301")
@example("C")
def test_whatever_they_say_rows_stay_as_wide_as_they_should(text: str) -> None:
    for state in states(text):
        for runs in lines(state):
            assert all(harmless(part) for part, _ in runs)
            assert width_of(cut(runs, 40)) == 40
        for width in WIDTHS:
            for row in queue_table(state, R0, False, width).rows:
                assert width_of(row.runs) == width - 1
                if row.buttons:  # an order that is over has nothing to cancel
                    assert cancel_at(row) == width - 1 - len(CANCEL)


def cancel_at(row: Row) -> int:
    *before, (text, _) = row.runs
    assert text == CANCEL
    assert row.buttons[0].start == width_of(before)
    return row.buttons[0].start


@given(TEXTS)
def test_the_map_gets_only_harmless_labels_and_notes(text: str) -> None:
    for state in states(text):
        scene = floor_scene(state, Selection(R0, F0))
        assert harmless(scene.note)
        assert all(harmless(vertex.label) for vertex in scene.vertices)
