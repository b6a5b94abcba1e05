"""Rows of /diagnostics: one for each part, the worst first, its values below while it is opened."""

from collections import Counter
from collections.abc import Collection, Hashable, Iterator, Mapping

from fleet_tui.model.order import natural
from fleet_tui.model.ros_logs import Health, PartDiagnosis
from fleet_tui.text.language import tr, translate
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.text.units import ago
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.diagnostics.links import Links, down
from fleet_tui.view.tables.table import Row, Table, column

OLD = 10.0
"""Seconds after which a report is old: robots report about once a second."""
_LOOKS: Mapping[int, tuple[str, StyleRole]] = {
    Health.OK: ("● OK", StyleRole.GOOD),
    Health.WARN: ("▲ WARN", StyleRole.WARN),
    Health.ERROR: ("✗ ERROR", StyleRole.ALARM),
    Health.STALE: ("○ STALE", StyleRole.WARN),
}
# Levels that the message does not define may mean anything.
_BY_LEVEL: Mapping[int, int] = {Health.ERROR: 0, Health.STALE: 1, Health.WARN: 2, Health.OK: 3}


def _look(level: int) -> tuple[str, StyleRole]:
    return _LOOKS.get(level, (tr("? level {level}", level=level), StyleRole.WARN))


def health_table(links: Links, opened: Collection[Hashable], wanted: str, now: float) -> Table:
    """Return the parts, the worst first; `opened` are the keys of rows whose values are shown."""
    sought = wanted.casefold()
    found = sorted(
        (
            ((link.name, one.name), one)
            for link, counter in links
            for one in counter.health.values()
            if sought in f"{one.name} {one.message} {one.hardware}".casefold()
        ),
        key=lambda entry: (_BY_LEVEL.get(entry[1].level, 0), natural(entry[1].name)),
    )
    names = column((one.name for _, one in found), 6, 30)
    rows = [row for key, one in found for row in _rows(key, one, names, key in opened, now)]
    levels = Counter(_look(one.level)[0][2:] for _, one in found if one.level != Health.OK)
    note = tr(" /diagnostics  {count} parts", count=len(found))
    note += "".join(f", {count} {word}" for word, count in sorted(levels.items()))
    note += tr(", matching {text}", text=sanitize(wanted)) if wanted else ""
    title = (tr("Robot diagnostics"), StyleRole.TITLE), (note, StyleRole.DIM), *down(links)
    empty = (
        tr("no matching part")
        if wanted
        else tr("nothing received on /diagnostics (subscribed while this screen is open)")
    )
    return Table(title, rows, empty)


def _rows(key: Hashable, one: PartDiagnosis, names: int, is_open: bool, now: float) -> Iterator[Row]:
    word, role = _look(one.level)
    is_old = now - one.at > OLD
    came = translate(ago(one.at, now))
    if is_old:
        came = tr("old, {ago}", ago=came)
    yield Row(
        key,
        (
            (f"{word:<10}", StyleRole.DIM if is_old else role),
            (fit(one.name, names) + " ", StyleRole.TEXT),
            (f"{came:>15}  ", StyleRole.WARN if is_old else StyleRole.DIM),
            (sanitize(one.message), StyleRole.TEXT),
        ),
    )
    if is_open:
        for n, (name, value) in enumerate(((tr("hardware"), one.hardware), *one.values)):
            shown = ((f"          {sanitize(name)}: ", StyleRole.DIM), (sanitize(value), StyleRole.TEXT))
            yield Row((key, n), shown)
