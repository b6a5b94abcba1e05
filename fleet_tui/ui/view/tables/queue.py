"""The queue pane: a robot's orders, the current one first, each with its Cancel."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial

from fleet_tui.commands.order_search import find_order
from fleet_tui.model import kind
from fleet_tui.model.commands import CancelOrder, ClearOrders, CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.order import Order, OrderState, vertices_of
from fleet_tui.model.robot import Robot
from fleet_tui.orders.ends import placed_by
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import cell_width, fit, sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.lines.commands import stage_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.columns import Column, FittedColumns
from fleet_tui.ui.view.tables.fleet import CARGO
from fleet_tui.ui.view.tables.missions import distance_left, left_text, mission, progress_text, whose_mission
from fleet_tui.ui.view.tables.table import Button, LateRows, Row, Run, Table, column, cut, width_of

CANCEL = Message("[Cancel]")
CLEAR = Message("[Clear all]")
GAP = "  "
SHORT = {OrderState.IN_PROCESS: Message("now")}
HOURS_MINUTES = 5
WIDE = 60
WITH_LEFT = 48
WITH_AGE = 60
WITH_POSITION = 70
LEAST_TITLE = 16
LEAST_NAME = 10
"""Cells from which ids are longer, and from which orders have columns for what is left, their age and
place; those that the title must keep beside its button, and of those for the name."""

Clock = Callable[[float], str]
Listed = tuple[Robot, int, Order]


def listed(state: FleetState, selected: str, all_robots: bool) -> list[Listed]:
    """Return (robot, position from 0, order) of the selected robot's orders, or of all robots'."""
    robots = state.robots.values() if all_robots else [state.robots[selected]]
    return [
        (robot, position, order)
        for robot in robots
        for position, order in enumerate(all_orders(state, robot))
    ]


def _under_way(state: FleetState, selected: str, all_robots: bool) -> list[CommandRecord]:
    return [
        record
        for record in state.commands
        if not record.is_decided and (all_robots or record.command.robot == selected)
    ]


def _awaited(state: FleetState, under_way: list[CommandRecord]) -> int:
    """Return the number of orders given here that no queue shows yet: one in a queue may lack its answer.
    One to any robot is in no robot's queue while fleets bid for it."""
    sent = (one for one in under_way if one.stage is not Stage.WAITING)
    placed = [one for one in sent if isinstance(order := one.command, PlaceOrder) and not order.to_any]
    names = [one.command.robot for one in placed]
    found = [find_order(state, state.robots[name], one) for name, one in zip(names, placed, strict=True)]
    return len(placed) - len({(name, one.id) for name, one in zip(names, found, strict=True) if one})


def _leaving(state: FleetState, records: Iterable[CommandRecord]) -> Mapping[tuple[str, str], str]:
    """Return by robot and order the stage of its cancellation; an empty order means all."""
    return {
        (command.robot, command.order_id if isinstance(command, CancelOrder) else ""): stage_text(
            record, state.now
        )
        for record in records
        if isinstance(command := record.command, CancelOrder | ClearOrders)
    }


def _mission(mission: str, cells: int, order: Order, space: int) -> tuple[str, str]:
    """Return an order's mission and its state: in columns, close together if space is short, or without
    the state of one in the queue."""
    status = translate(sanitize(order.state_text))
    if cells + len(GAP) + cell_width(status) <= space:
        return fit(mission, cells) + GAP, status
    short = translate(SHORT[order.state]) if order.state in SHORT else status
    shown = fit(mission, cells).rstrip()
    if not order.is_over and cell_width(shown) + len(", ") + cell_width(short) > space:
        return shown, ""  # its place in the queue says as much as two letters of it
    return shown + ", ", short


def _told(
    state: FleetState, entry: Listed, cells: tuple[int, int], leaving: str, has_left: bool
) -> list[Run]:
    """Return the mission of an order and its state, of a column for missions and of all cells that there are
    for both."""
    robot, _, order = entry
    unknown = robot.knows_all_graphs() and None in map(robot.name_of, vertices_of(order.stops))
    mission, status = _mission(whose_mission(state, robot, order), cells[0], order, cells[1])
    role = StyleRole.TEXT if robot.orders.is_current(order) else StyleRole.DIM
    progress = progress_text(state, robot, order, has_left)
    return [
        (mission, StyleRole.WARN if unknown else StyleRole.TEXT),
        (status, role),
        (f", {progress}" if progress else "", StyleRole.DIM),
        (tr(", cancel {leaving}", leaving=leaving) if leaving else "", StyleRole.WARN),
        (tr(", unknown vertex") if unknown else "", StyleRole.WARN),
    ]


def _waiting_since(state: FleetState, entry: Listed) -> tuple[float, bool] | None:
    """Return the monotonic second at which an order was taken, or was first listed here, and whether it is
    that of its beginning: it may be older than its first list. None if it is unknown."""
    robot, _, order = entry
    if order.taken_at is not None:
        return order.taken_at, True
    record = placed_by(state, robot, order)
    if record is not None:
        return record.issued_at, True
    trace = robot.traces.get(order.id)
    return None if trace is None or trace.listed_at is None else (trace.listed_at, False)


def _age(state: FleetState, entry: Listed) -> Run:
    since = _waiting_since(state, entry)
    if since is None:
        return "", StyleRole.DIM
    at, is_exact = since
    return f"{'' if is_exact else '> '}{age(state.now - at)}", StyleRole.DIM


def _title(
    robot: Robot,
    state: FleetState,
    count: int,
    placed: int,
    all_robots: bool,
    width: int,
    clock: Clock | None,
) -> list[Run]:
    ours = not all_robots and robot.kind.keeps_goals
    runs: list[Run] = [
        (tr("Queue all robots") if all_robots else tr("Queue {name}", name=robot.name), StyleRole.TITLE)
    ]
    if all_robots or (robot.kind.lists_orders and (count or not ours)):
        runs.append((" " + translate(counted("{count} order", "{count} orders", count)), StyleRole.DIM))
    if ours and robot.held:
        runs.append((tr(" held: {held}", held=translate(sanitize(robot.held))), StyleRole.WARN))
    if placed:
        runs.append((tr(" +{placed} not in the queue yet", placed=placed), StyleRole.WARN))
    if not all_robots and robot.has_cargo:
        texts = (tr(" cargo on board"), tr(" cargo"), f" {CARGO}")
        left = width - width_of(runs) - len(translate(CLEAR)) - 2
        runs.append((next((text for text in texts if len(text) <= left), texts[-1]), StyleRole.TEXT))
    if not all_robots:
        runs += _ages(state, robot, clock)
    return runs


def _within(title: list[Run], cells: int) -> list[Run]:
    """Return a title for this many cells: first the number of orders goes, then the end of the name."""
    while width_of(title) > cells and (dim := [run for run in title if run[1] is StyleRole.DIM]):
        title.remove(dim[0])
    (name, role), *rest = title
    least = max(LEAST_NAME, cells - width_of(rest))
    is_long = width_of(title) > cells and cell_width(name) > least
    return [(fit(name, least), role), *rest] if is_long else title


def _ages(state: FleetState, robot: Robot, clock: Clock | None) -> Iterator[Run]:
    """Yield the age of an old queue, and since when it is known."""
    if robot.queue is not None and state.is_old(robot, "queue"):
        yield tr(" {age} old", age=age(state.now - robot.queue.at)), StyleRole.WARN
    wall = known_since(state, robot)
    if wall is not None and clock is not None:
        yield tr(" since {wall}", wall=clock(wall)[:HOURS_MINUTES]), StyleRole.TEXT


def known_since(state: FleetState, robot: Robot) -> float | None:
    """Return the Unix time since which a robot's orders are known, if a late console is not told all."""
    link = state.links[robot.link]
    if not robot.kind.is_told_changes or link.phase is not Phase.UP:
        return None
    return state.wall - (state.now - link.since)


def _rows(
    state: FleetState, entries: Sequence[Listed], columns: FittedColumns[Listed], buttons: bool, width: int
) -> LateRows:
    """Return a row for each order, most with a button in their last cells; `buttons`: there may be some."""
    name = translate(CANCEL)
    start = width - 1 - len(name)

    def row(place: int) -> Row:
        robot, position, order = entries[place]
        runs = columns.runs(entries[place])
        if not buttons or order.is_over or not robot.kind.can(kind.CANCEL):
            return Row((robot.name, order.id, position), cut(runs, width - 1))
        return Row(
            (robot.name, order.id, position),
            (*cut(runs, start), (name, StyleRole.KEY)),
            (Button(start, start + len(name), "cancel"),),
        )

    return LateRows([(robot.name, order.id, position) for robot, position, order in entries], row)


def queue_columns(
    state: FleetState,
    entries: Sequence[Listed],
    leaving: Mapping[tuple[str, str], str],
    all_robots: bool,
    width: int,
    rest: Callable[[], int],
) -> Sequence[Column[Listed]]:
    """Return the columns for rows of `width` cells; `rest` returns those of the mission with its state."""
    longest = 12 if width >= WIDE else 9
    ids = column((f"#{order.id}" for _, _, order in entries), 2, longest)
    missions = column((whose_mission(state, robot, order) for robot, _, order in entries), 10, 40)

    def told(entry: Listed) -> list[Run]:
        robot, _, order = entry
        stage = leaving.get((robot.name, order.id)) or leaving.get((robot.name, ""), "")
        return _told(state, entry, (missions, rest()), stage, width >= WITH_LEFT)

    def left(entry: Listed) -> Run:
        return left_text(state, entry[0], entry[2]), StyleRole.DIM

    def by_mission(entry: Listed) -> str:
        return mission(entry[0], entry[2])

    def by_age(entry: Listed) -> float:
        since = _waiting_since(state, entry)
        return math.inf if since is None else since[0]

    def by_left(entry: Listed) -> float:
        metres = distance_left(state, entry[0], entry[2])
        return math.inf if metres is None else metres

    return (
        Column(
            N_("robot"),
            (lambda entry: entry[0].name) if all_robots else None,
            (6, 12),
            tr("Robot"),
            text=lambda entry: entry[0].name,
            sorts=True,
            stays=True,
        ),
        Column(
            N_("id"),
            lambda entry: (f"#{entry[2].id}", StyleRole.DIM),
            ids,
            "",
            text=lambda entry: entry[2].id,
            stays=True,
            ends_differ=True,
        ),
        Column(
            N_("position"),
            lambda entry: (str(entry[1] + 1), StyleRole.DIM),
            3,
            tr("Pos"),
            WITH_POSITION,
            is_right=True,
        ),
        Column(N_("order"), told, None, tr("Order"), text=by_mission, order=by_mission),
        Column(N_("state"), text=lambda entry: entry[2].state_text, sorts=True),
        Column(N_("distance"), left, 8, tr("Left"), WITH_LEFT, order=by_left, is_right=True),
        Column(N_("age"), partial(_age, state), 7, tr("Age"), WITH_AGE, order=by_age, is_right=True),
    )


def queue_table(
    state: FleetState,
    selected: str,
    all_robots: bool,
    width: int,
    arrangement: RowArrangement | None = None,
    may: bool = True,
    clock: Clock | None = None,
) -> Table:
    """Return the orders in a pane of `width` cells, as arranged; `may`: their user has the right to change
    them; `clock` writes Unix times."""
    arrangement = arrangement or RowArrangement()
    known = listed(state, selected, all_robots)
    under_way = _under_way(state, selected, all_robots)
    robot = state.robots[selected]
    has_buttons = may and any(one.kind.can(kind.CANCEL) and not order.is_over for one, _, order in known)
    space = width - 1 - len(translate(CANCEL)) * has_buttons
    columns = queue_columns(
        state, known, _leaving(state, under_way), all_robots, space, lambda: shown.rest - 1
    )
    entries = arrangement.arranged(known, columns)
    shown = FittedColumns(columns, entries, space)
    rows = _rows(state, entries, shown, has_buttons, width)
    title = _title(robot, state, len(known), _awaited(state, under_way), all_robots, width, clock)
    title[1:1] = arrangement.notes(len(entries))
    listing = any(one.kind.lists_orders for one in state.robots.values())
    buttons: tuple[Button, ...] = ()
    if may and not all_robots and rows and robot.kind.can(kind.CLEAR):
        start = width - len(translate(CLEAR)) - 2  # its end above that of [Cancel]
        if start > LEAST_TITLE:
            title = [*cut(_within(title, start - 1), start - 1), (" " + translate(CLEAR), StyleRole.KEY)]
            buttons = (Button(start, start + len(translate(CLEAR)), "clear"),)
    else:
        title = _within(title, width)
    empty = tr("no orders") if all_robots and listing else _empty(robot, may)
    return Table(
        tuple(title),
        rows,
        arrangement.no_match if known else empty,
        buttons,
        shown.head if space >= WITH_LEFT else (),
        unfiltered=len(known),
        stays=shown.stays,
    )


def _empty(robot: Robot, may: bool) -> str:
    """Return the text shown without orders."""
    if not robot.kind.lists_orders:
        return tr("this kind has no queue")
    if robot.queue is not None:
        return tr("no orders") + tr(": press o to order") * (may and robot.kind.can(kind.ORDER))
    return tr("no queue received yet") if robot.kind.expects("queue") else tr("no orders reported yet")
