"""A robot's page: its sections in one or two columns, beside the battery curve."""

from collections.abc import Callable, Iterator, Sequence
from itertools import zip_longest

from msgspec import Struct

from fleet_tui.model.audit_record import PastAlarm
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.battery.forecast import BatteryForecast
from fleet_tui.situation.why.complaints import Complaint
from fleet_tui.text.language import EMPTY, Message, tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age
from fleet_tui.ui.view.robot.sections import (
    STATE,
    Clock,
    Line,
    PageSection,
    alarms_section,
    commands_section,
    factsheet_section,
    orders_section,
    route_section,
    state_section,
)
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, cut, width_of

COLUMNS_FROM = 110
"""Cells from which all sections are in two columns."""
BESIDE_FROM = 74
"""Cells from which the curve is beside the state."""
BELOW_FROM = 30
"""Lines from which it is below the state, as wide as the page."""
BETWEEN = 1
LOW_CURVE = 8
HIGH_CURVE = 18
HOURS_MINUTES = 5

Curve = Callable[[int, int], Sequence[Line]]
"""Draws the battery curve in lines of a width and a height; no lines without a level."""


class PageContent(Struct, frozen=True):
    """The contents of a page: `curve` is None while its drawing is loaded; `past` are the alarms that are
    over, `note` is said about them, `complaints` are the robot's own."""

    state: FleetState
    robot: Robot
    clock: Clock
    curve: Curve | None
    forecast: BatteryForecast | None
    past: Sequence[PastAlarm] = ()
    note: Message = EMPTY
    complaints: Sequence[Complaint] = ()


def page_title(state: FleetState, name: str) -> tuple[Run, ...]:
    """Return the robot, its kind and link, and its place in the configuration."""
    robot, names = state.robots[name], list(state.robots)
    about = tr(
        "  {name} on {link}, {index} of {names}",
        name=robot.kind.name,
        link=sanitize(robot.link),
        index=names.index(name) + 1,
        names=len(names),
    )
    return (f" {sanitize(name)}", StyleRole.TITLE_FOCUSED), (about, StyleRole.DIM)


def page_lines(content: PageContent, width: int, height: int) -> list[Line]:
    """Return the page in lines of `width` cells; `height` are the lines that are visible at once."""
    parts = content.state, content.robot
    state = state_section(*parts, content.complaints)
    route, orders = route_section(*parts), orders_section(*parts)
    alarms = alarms_section(*parts, content.past, content.clock, content.note)
    commands = commands_section(*parts, content.clock)
    sheet = (factsheet_section(content.robot),) if content.robot.factsheet else ()
    if width >= COLUMNS_FROM:
        left = max(STATE, width * 2 // 5)
        right = width - left - BETWEEN
        curve = _battery(content, right, max(LOW_CURVE, min(HIGH_CURVE, height // 3)))
        return _beside(
            _drawn((state, route, orders, *sheet), left),
            _drawn((curve, alarms, commands), right),
            left,
            right,
        )
    rest = _drawn((route, orders, alarms, commands, *sheet), width)
    if width < BESIDE_FROM or height >= BELOW_FROM:
        lines = max(LOW_CURVE, min(HIGH_CURVE, height // 4))
        return [*_drawn((state, _battery(content, width, lines)), width), *rest]
    right = width - STATE - BETWEEN
    above = _battery(content, right, max(LOW_CURVE, len(state.lines)))
    return [*_beside(state.drawn(STATE), above.drawn(right), STATE, right), *rest]


def _drawn(sections: Sequence[PageSection], width: int) -> list[Line]:
    return [line for section in sections for line in section.drawn(width)]


def _beside(one: Sequence[Line], other: Sequence[Line], left: int, right: int) -> list[Line]:
    between = (" " * BETWEEN, StyleRole.TEXT)
    return [(*cut(a, left), between, *cut(b, right)) for a, b in zip_longest(one, other, fillvalue=())]


def _battery(content: PageContent, width: int, height: int) -> PageSection:
    """Return the curve of the levels that this console saw, and in its title the guess that fits."""
    title: tuple[Run, ...] = ((tr("Battery"), StyleRole.TITLE),)
    for guess in _guesses(content):
        told = (*title, (f" {guess}", StyleRole.TEXT))
        if width_of(told) + 4 <= width:
            title = told
            break
    if "battery" not in content.robot.kind.reports:
        return PageSection(title, (), tr("this kind of robot reports none"))
    lines = content.curve(width, height) if content.curve is not None else ()
    return PageSection(title, lines, tr("none seen yet") if content.curve is not None else "...")


def _guesses(content: PageContent) -> Iterator[str]:
    """Yield the forecast in words, the longest first."""
    guess = content.forecast
    if guess is None:
        return
    left = tr("{age} left", age=age(guess.empty_in))
    if guess.low_in is not None:
        low = tr("low at {wall}", wall=content.clock(content.state.wall + guess.low_in)[:HOURS_MINUTES])
        yield tr("a guess: {low}, about {left}", low=low, left=left)
        yield tr("maybe {low}", low=low)
    yield tr("a guess: about {left}", left=left)
    yield tr("maybe {left}", left=left)
