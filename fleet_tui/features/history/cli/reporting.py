"""`fleet-tui report`: a shift on one page of HTML."""

import base64
import io
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from pathlib import Path

from fleet_tui import __version__
from fleet_tui.config.schema import Config
from fleet_tui.features.history.cli.printing import unwatched
from fleet_tui.features.history.report.axis import LocalTime
from fleet_tui.features.history.report.content import Claim, Handover, ReportContent
from fleet_tui.features.history.report.heat import FloorHeat, around
from fleet_tui.features.history.report.page import page
from fleet_tui.maps.floor_files import load_maps
from fleet_tui.model.commands import FAILURES
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.history.totals import BlockedPlace, ChargeTotal
from fleet_tui.model.order import natural
from fleet_tui.records.desk.desk import shown
from fleet_tui.records.desk.presence import PresenceReader
from fleet_tui.records.history.division import divided
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.shift import NOT_DRIVEN, causes_of, counted, outages_of, robots_of
from fleet_tui.records.history.timeline import main_activities, shares
from fleet_tui.records.history.totals import Totals
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

PARTS = 240
"""Parts of the time in the pictures, at most."""
MAP_PIXELS = 700
"""Pixels of a map's picture in each direction, at most."""
GREYS = (225, 255, 90)
"""Of unknown, free and occupied cells."""


def write_report(config: Config, history: History, since: float, until: float, path: Path) -> int:
    """Write the report of a time; return its bytes. Raises FleetError if it can't be written."""
    document = page(_content(config, history, Totals(history.database), since, until)).encode()
    try:
        write_whole(path, document, is_shared=True)
    except OSError as problem:
        raise FleetError(Message("{path}: {strerror}", path=path, strerror=problem.strerror)) from None
    return len(document)


def _content(config: Config, history: History, totals: Totals, since: float, until: float) -> ReportContent:
    time, failed = divided(since, until, PARTS), frozenset(stage.value for stage in FAILURES)
    orders, activities, charges = totals.orders(since, until), totals.activities(time), totals.charges(time)
    robots = robots_of(orders, activities, charges)
    names = [robot.name for robot in robots]
    return ReportContent(
        site=_site(config),
        since=since,
        until=until,
        made_by=f"fleet-tui {__version__}",
        begun=_begun(history, since),
        unwatched=unwatched(history.watched_until(), until).strip(),
        notes=history.notes(since, until),
        robots=robots,
        routes=counted(orders, "way"),
        handover=_handover(config, history),
        causes=causes_of(history.alarms(since, until), since, until),
        outages=outages_of(history.links(since, until), since, until),
        losses=history.orders(since, until, stages=NOT_DRIVEN),
        refusals=history.commands(since, until, stages=failed),
        time=time,
        timeline=main_activities(names, time, activities) if time.is_exact else {},
        shares={} if time.is_exact else shares(names, time, activities),
        charges=_by_robot(charges),
        floors=list(_floors(config, totals.blocked(since, until))),
        battery_low=config.alarms.battery_low,
        local=LocalTime(_offset(until), _clock, _moment),
    )


def _handover(config: Config, history: History) -> Handover:
    orders, alarms = history.open_orders(), history.open_alarms()
    if not config.desk.folder:
        return Handover(orders, alarms, ())
    folder = config.beside(config.desk.folder)
    try:
        found = PresenceReader(folder).look()
    except OSError as problem:
        return Handover(orders, alarms, (), f"{folder}: {problem.strerror}")
    ours = {robot.name for robot in config.robots}
    claims = [
        Claim(robot, shown(one.name), shown(one.host))
        for one in found
        for robot in one.claims
        if robot in ours
    ]
    return Handover(orders, alarms, sorted(claims, key=lambda claim: natural(claim.robot)))


def _begun(history: History, since: float) -> float | None:
    """Return when a robot was first observed, None if that was not later than the time's begin."""
    begun = history.begun()
    return begun if begun is not None and begun > since + 60.0 else None


def _site(config: Config) -> str:
    """Return the folder of the configuration, which people name after their site, else the address."""
    return config.path.absolute().parent.name if config.path.suffix else config.rosbridge.shown


def _by_robot(charges: Sequence[ChargeTotal]) -> Mapping[str, Sequence[ChargeTotal]]:
    found: dict[str, list[ChargeTotal]] = {}
    for charge in charges:
        found.setdefault(charge.robot, []).append(charge)
    return {name: found[name] for name in sorted(found, key=natural)}


def _floors(config: Config, places: Sequence[BlockedPlace]) -> Iterator[FloorHeat]:
    """Return the floors with blocked places, on their maps where the configuration has files."""
    grids = {one.floor: one.grid for one in load_maps(config) if one.tied} if places else {}
    for name in dict.fromkeys(place.floor for place in places):
        here, grid = [place for place in places if place.floor == name], grids.get(name)
        if grid is None:
            yield FloorHeat(name, here, around(here))
        else:
            yield FloorHeat(name, here, grid.frame, _picture(grid))


def _picture(grid: OccupancyGrid) -> str:
    """Return a small PNG of a map as a data URL."""
    from PIL import Image  # takes longer to import than a page without a map

    level = next((one for one in grid.levels if max(one.shape) <= MAP_PIXELS), grid.levels[-1])
    image = Image.fromarray(level.copy(), "P")
    image.putpalette([grey for grey in GREYS for _ in range(3)])
    file = io.BytesIO()
    image.save(file, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}"


def _clock(at: float, is_long: bool) -> str:
    return f"{datetime.fromtimestamp(at).astimezone():{'%d %b' if is_long else '%H:%M'}}"


def _moment(at: float, with_year: bool) -> str:
    return f"{datetime.fromtimestamp(at).astimezone():{'%Y-%m-%d %H:%M' if with_year else '%m-%d %H:%M'}}"


def _offset(at: float) -> float:
    offset = datetime.fromtimestamp(at).astimezone().utcoffset()
    return offset.total_seconds() if offset is not None else 0.0
