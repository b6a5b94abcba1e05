"""The `graph lint` command."""

from collections import Counter
from collections.abc import Callable
from pathlib import Path

from fleet_tui.features.graphs.cli.answers import GraphAnswers, graph_counts, load
from fleet_tui.features.graphs.cli.map_image import map_grid
from fleet_tui.features.graphs.rules.difference import GraphChange, difference
from fleet_tui.features.graphs.rules.finding import GraphFinding, LintInputs
from fleet_tui.features.graphs.rules.lint import lint as findings_of
from fleet_tui.model.graphs.document import GraphDocument, GraphFormat
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted

KINDS = ("added", "removed", "moved", "relabelled", "retyped", "rewired")


def diff(say: Callable[[str], None], before: str, after: str, answers: GraphAnswers) -> int:
    """Print the changes and their numbers; return 1 if there are any. Raises GraphError."""
    old, answers = load(before, None, answers)
    new, _ = load(after, None, answers)
    found = list(_changes(old.document, new.document))
    for floor, change in found:
        where = f"{floor}: " if floor else ""
        say(sanitize(f"{change.kind}: {where}{change.text}"))
    counts = Counter(change.kind for _, change in found)
    say(", ".join(f"{counts[kind]} {kind}" for kind in KINDS if counts[kind]) or "no difference")
    return 1 if found else 0


def _changes(old: GraphDocument, new: GraphDocument) -> list[tuple[str, GraphChange]]:
    """Return the changes with their floors; of two documents of one floor each its name does not matter."""
    if len(old.floors) == len(new.floors) == 1:
        (before,), (after,) = old.floors.values(), new.floors.values()
        return [("", change) for change in difference(before, after)]
    found = list[tuple[str, GraphChange]]()
    for name in dict.fromkeys([*old.floors, *new.floors]):
        if name not in old.floors or name not in new.floors:
            kind = "removed" if name in old.floors else "added"
            found.append(("", GraphChange(kind, f"floor {name}")))
            continue
        found += [(name, change) for change in difference(old.floors[name], new.floors[name])]
    return found


UNNUMBERED = (GraphFormat.RMF_BUILDING, GraphFormat.RMF_SITE)
"""Formats whose rules are those of another: the graph made from a building or a site is an RMF graph."""


def lint(
    say: Callable[[str], None],
    file: str,
    map_file: str | None,
    width: float,
    wanted: str | None,
    answers: GraphAnswers,
) -> int:
    """Print the findings and their numbers; return 1 if there are any. Raises GraphError, MapError."""
    read, answers = load(file, wanted, answers)
    grid = map_grid(map_file, read.document) if map_file else None
    target = GraphFormat.RMF if read.format in UNNUMBERED else read.format
    inputs = LintInputs(grid, width, target=target)
    found = findings_of(read.document, inputs)
    many = len(read.document.floors) > 1
    for one in found:
        say(sanitize(_line(one, many)))
    errors = sum(one.is_error for one in found)
    counts = f"{counted(errors, 'error')}, {counted(len(found) - errors, 'warning')}"
    say(sanitize(f"{Path(file).name}: {read.format.value}, {graph_counts(read.document)}: {counts}"))
    return 1 if found else 0


def _line(finding: GraphFinding, many: bool) -> str:
    kind = "error" if finding.is_error else "warning"
    where = f"{finding.floor}: " if many and finding.floor else ""
    return f"{kind}: {where}{finding.text}"
