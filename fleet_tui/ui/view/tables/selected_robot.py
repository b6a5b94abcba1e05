"""The selected robot on one page: its values with their ages, its order, its last commands."""

import math
from collections.abc import Callable, Iterator
from textwrap import wrap
from typing import Any

from fleet_tui.model.commands import FAILURES, ORDER_ENDS
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.ends import ended_orders, seen_end
from fleet_tui.situation.alarms.classes import action_of
from fleet_tui.situation.facts import AGE_UNKNOWN
from fleet_tui.situation.links import is_late
from fleet_tui.situation.robots import adrift
from fleet_tui.situation.why.place import place_text
from fleet_tui.text.language import N_, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age, duration
from fleet_tui.ui.view.lines.commands import command_text, stage_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import FEW
from fleet_tui.ui.view.tables.doing import page_texts
from fleet_tui.ui.view.tables.missions import progress_text, whose_mission
from fleet_tui.ui.view.tables.news import with_commas, without_cause
from fleet_tui.ui.view.tables.short_names import floor_text
from fleet_tui.ui.view.tables.table import Row, Run, Table

NAME = 10
VALUE = 27
AGE = 8
"""Cells of the columns of names, values and ages."""
LAST = 5
"""Commands and ended orders that are listed."""


def robot_page(state: FleetState, name: str, width: int, clock: Callable[[float], str]) -> Table:
    """Return the page of a robot for a pane of `width` cells; `clock` formats Unix seconds as local time."""
    robot = state.robots[name]
    rows = [
        named(tr("State"), *with_commas(page_texts(state, robot, width - NAME - 1))),
        *value_rows(state, robot, width),
        *_alarms(state, robot, width - NAME - 1),
    ]
    rows += [*_orders(state, robot), *command_rows(state, robot, clock)]
    listed = tuple(Row(None, runs) for runs in rows if runs)
    title = (
        (sanitize(name), StyleRole.TITLE),
        (tr(" {name} on {link}", name=robot.kind.name, link=sanitize(robot.link)), StyleRole.DIM),
    )
    return Table(title, listed)


def named(name: str, *runs: Run) -> tuple[Run, ...]:
    """Return a line with its name, empty without runs."""
    if not runs:
        return ()
    spaced = [run for one in runs for run in (one, (" ", StyleRole.TEXT))]
    return ((f"{name:<{NAME}}", StyleRole.DIM), *spaced)


def _alarms(state: FleetState, robot: Robot, width: int) -> Iterator[tuple[Run, ...]]:
    """Yield each alarm as a whole, and what to do; of a few, which the alarms pane explains, the name."""
    own = [one for one in state.alarms if one.holds and one.condition.source == robot.name]
    for alarm in own:
        if len(state.alarms) <= FEW:
            yield named(tr("Alarm"), (translate(sanitize(without_cause(alarm, alarm.text))), StyleRole.TEXT))
            continue
        for n, line in enumerate(wrap(translate(sanitize(alarm.text)), max(20, width))):
            yield named(tr("") if n else tr("Alarm"), (line, StyleRole.TEXT))
        for line in wrap(translate(action_of(alarm.condition)), max(20, width)):
            yield named(tr(""), (line, StyleRole.DIM))


def value_rows(state: FleetState, robot: Robot, width: int) -> Iterator[tuple[Run, ...]]:
    """Yield each value that this kind of robot reports, with its age; in less than the `width` of the columns
    closer, and without `ago`. A pose has the age of its stamp; the others are as old as they are late."""
    is_narrow = width <= NAME + VALUE + AGE
    cells = VALUE - 2 if is_narrow else VALUE
    texts: dict[str, tuple[str, Reading[Any] | None]] = {
        N_("Pose"): (_pose_text(state, robot, is_narrow), robot.pose),
        N_("Battery"): (_percent(robot.battery), robot.battery),
        N_("Cargo"): (_yes_or_no(robot.cargo), robot.cargo),
        N_("Obstacle"): (_contact(robot.obstacle), robot.obstacle),
        N_("Paused"): (_yes_or_no(robot.paused), robot.paused),
    }
    link = state.links[robot.link]
    late = link.late if is_late(link) else 0.0
    for name, (text, reading) in texts.items():
        value = name.casefold()
        if value not in robot.kind.reports:
            continue
        if reading is None:
            yield named(tr(name), (tr("not received"), StyleRole.DIM))
            continue
        is_old = not state.is_fresh(robot, value)
        since = _since(state.now - reading.at + (value != "pose") * late, is_narrow)
        if value == "pose" and robot.is_undated:
            since = translate(AGE_UNKNOWN.word)
        if value == "pose" and (estimate := adrift(state, robot)) is not None:
            # Its wheels renew it: what counts is when it was last localised.
            since = _since(state.now - estimate.since, is_narrow)
            is_old = True
        age_role = StyleRole.WARN if is_old or late else StyleRole.DIM
        yield named(
            tr(name),
            (f"{text:<{cells}}", StyleRole.DIM if is_old else StyleRole.TEXT),
            # In whole seconds: tenths would never be at rest.
            (since, age_role),
        )
    yield from _place(state, robot)


def _since(seconds: float, is_narrow: bool) -> str:
    return age(seconds) if is_narrow else tr("{age} ago", age=age(seconds))


def _place(state: FleetState, robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield the place it is at, its mode, and the last jump of its pose."""
    if place := place_text(robot):
        yield named(tr("Place"), (translate(sanitize(place)), StyleRole.TEXT))
    if robot.member is not None and (mode := robot.member.value.mode or robot.member.value.status):
        role = StyleRole.TEXT if state.is_fresh(robot, "member") else StyleRole.DIM
        yield named(tr("Mode"), (translate(sanitize(mode)), role))
    if robot.relocated is not None:
        yield named(
            tr("Jumped"),
            (f"{translate(sanitize(robot.relocated.value)):<{VALUE}}", StyleRole.TEXT),
            (tr("{age} ago", age=age(state.now - robot.relocated.at)), StyleRole.DIM),
        )


def _pose_text(state: FleetState, robot: Robot, is_narrow: bool) -> str:
    """Return a pose, in few cells without the floor that the place tells."""
    if robot.pose is None:
        return ""
    pose = robot.pose.value
    degrees = f"{math.degrees(pose.yaw):.0f}°" if math.isfinite(pose.yaw) else tr("no heading")
    floor = "" if is_narrow and place_text(robot) else f", {floor_text(state, robot)}"
    if robot.is_estimated:
        return tr("about {x}, {y} m{floor}", x=f"{pose.x:.1f}", y=f"{pose.y:.1f}", floor=floor)
    return f"{pose.x:.1f}, {pose.y:.1f} m, {degrees}{floor}"


def _percent(reading: Reading[float] | None) -> str:
    """Return a battery as the fleet pane has it: rounded down."""
    return "" if reading is None or not math.isfinite(reading.value) else f"{int(reading.value)} %"


def _contact(reading: Reading[float] | None) -> str:
    return (
        tr("none")
        if reading is None or reading.value == 0.0
        else tr("for {duration}", duration=duration(reading.value))
    )


def _yes_or_no(reading: Reading[bool] | None) -> str:
    return "" if reading is None else tr("yes") if reading.value else tr("no")


def _orders(state: FleetState, robot: Robot) -> Iterator[tuple[Run, ...]]:
    current = robot.orders.current
    if current is not None:
        progress = progress_text(state, robot, current)
        text = whose_mission(state, robot, current) + (f", {progress}" if progress else "")
        yield named(tr("Order"), (text, StyleRole.TEXT))
    yield from ended_rows(state, robot)


def ended_rows(state: FleetState, robot: Robot) -> Iterator[tuple[Run, ...]]:
    """Yield the last orders that left the queue, each with its end."""
    for gone in reversed(ended_orders(state, robot)[-LAST:]):
        text = whose_mission(state, robot, gone.order)
        end = seen_end(state, robot, gone).stage
        role = StyleRole.WARN if end in FAILURES else StyleRole.TEXT
        ended = tr("{age} ago", age=age(state.now - gone.at)), StyleRole.DIM
        yield named(tr("Ended"), (f"{text}: {tr(end.value)}", role), ended)
        if gone is robot.gone[-1] and (remedy := ORDER_ENDS[end].remedy):
            yield named(tr(""), (translate(remedy), StyleRole.TEXT))


def command_rows(state: FleetState, robot: Robot, clock: Callable[[float], str]) -> Iterator[tuple[Run, ...]]:
    """Yield the last commands of this console, each with its outcome."""
    own = [record for record in state.commands if record.command.robot == robot.name]
    for record in reversed(own[-LAST:]):
        text = command_text(state, record.command).removeprefix(f"{robot.name} ")
        yield named(clock(record.wall), (f"{text}: {stage_text(record, state.now)}", StyleRole.TEXT))
