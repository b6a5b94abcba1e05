"""Rows of /diagnostics: one for each part, the worst first, its values below while it is opened."""

from collections import Counter
from collections.abc import Collection, Hashable, Iterator, Mapping, Sequence

from fleet_tui.model.order import natural
from fleet_tui.model.ros_logs import Health, PartDiagnosis
from fleet_tui.text.language import N_, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import ago
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.diagnostics.links import Links, down
from fleet_tui.ui.view.tables.table import Row, Run, Table

OLD = 10.0
"""Seconds after which a report is old: robots report about once a second."""
Entry = tuple[tuple[str, str], PartDiagnosis]
"""The key of a part, by its link and name, and the part."""
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


def health_table(
    links: Links,
    opened: Collection[Hashable],
    now: float,
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return the parts, the worst first; `opened` are the keys of rows whose values are shown."""
    parts = sorted(
        (((link.name, part.name), part) for link, counter in links for part in counter.health.values()),
        key=lambda entry: (_BY_LEVEL.get(entry[1].level, 0), natural(entry[1].name)),
    )
    levels = Counter(_look(part.level)[0][2:] for _, part in parts if part.level != Health.OK)
    note = tr(" /diagnostics  {count} parts", count=len(parts))
    note += "".join(f", {count} {word}" for word, count in sorted(levels.items()))
    return table_of(
        ((tr("Robot diagnostics"), StyleRole.TITLE), (note, StyleRole.DIM), *down(links)),
        _columns(now),
        parts,
        _key,
        width,
        arrangement=arrangement,
        below=lambda entry: _values(entry) if _key(entry) in opened else (),
        empty=tr("nothing received on /diagnostics (subscribed while this screen is open)"),
    )


def _key(entry: Entry) -> Hashable:
    return entry[0]


def _columns(now: float) -> Sequence[Column[Entry]]:
    def level(entry: Entry) -> Run:
        word, role = _look(entry[1].level)
        return word, StyleRole.DIM if is_old(entry) else role

    def came(entry: Entry) -> Run:
        at = translate(ago(entry[1].at, now))
        return (tr("old, {ago}", ago=at), StyleRole.WARN) if is_old(entry) else (at, StyleRole.DIM)

    def is_old(entry: Entry) -> bool:
        return now - entry[1].at > OLD

    return (
        Column(N_("level"), level, (9, 12), ""),
        Column(N_("name"), lambda entry: entry[1].name, (6, 30), "", sorts=True, stays=True),
        Column(N_("age"), came, 16, "", order=lambda entry: entry[1].at, is_right=True),
        Column(N_("message"), lambda entry: entry[1].message, None, ""),
        Column(N_("hardware"), text=lambda entry: entry[1].hardware),
    )


def _values(entry: Entry) -> Iterator[Row]:
    key, part = entry
    for n, (name, value) in enumerate(((tr("hardware"), part.hardware), *part.values)):
        shown = ((f"          {sanitize(name)}: ", StyleRole.DIM), (sanitize(value), StyleRole.TEXT))
        yield Row((key, n), shown)
