"""The `graph lint` command."""

from collections.abc import Callable
from pathlib import Path

from fleet_tui.cli.graph.answers import GraphAnswers, load
from fleet_tui.cli.graph.counts import graph_counts
from fleet_tui.cli.graph.map_image import map_grid
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.rules.graphs.finding import GraphFinding, LintInputs
from fleet_tui.rules.graphs.lint import lint as findings_of
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import counted

UNNUMBERED = (GraphFormat.RMF_BUILDING,)
"""Formats whose rules are those of another: the graph made from a building is an RMF graph."""


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
