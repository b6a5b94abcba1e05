"""The `graph diff` command."""

from collections import Counter
from collections.abc import Callable

from fleet_tui.cli.graph.answers import GraphAnswers, load
from fleet_tui.model.graphs.document import GraphDocument
from fleet_tui.rules.graphs.difference import GraphChange, difference
from fleet_tui.text.sanitize import sanitize

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
