"""Questions before a program is started, stopped or restarted: what depends on it, what it needs."""

from collections.abc import Iterator, Mapping

from fleet_tui.model.programs.program import ENDED, ProgramRow, ProgramState
from fleet_tui.text.language import N_, tr
from fleet_tui.text.limits import some
from fleet_tui.text.sanitize import sanitize

VERBS = {"start": N_("Start"), "stop": N_("Stop"), "restart": N_("Restart")}


def change_question(rows: Mapping[str, ProgramRow], name: str, verb: str, now: float) -> str:
    """Return the question, with a line for each consequence."""
    row = rows[name]
    where = tr(" on {host}", host=row.host) if row.host else ""
    lines = [
        tr(
            "{verb} {name}{where}? It is {state}.",
            verb=tr(VERBS[verb]),
            name=name,
            where=where,
            state=tr(row.state(now).value),
        )
    ]
    lines += consequences(rows, name, verb, now)
    return "\n".join(map(sanitize, lines))


def consequences(rows: Mapping[str, ProgramRow], name: str, verb: str, now: float) -> Iterator[str]:
    """Return what a start lacks, or what a stop or restart takes along."""
    row = rows[name]
    if verb == "start":
        for need in row.needs:
            if rows[need].state(now) is not ProgramState.RUNNING:
                yield tr(
                    "It needs {need}, which is {state}.", need=need, state=tr(rows[need].state(now).value)
                )
        return
    units = row.status.dependents if row.status is not None else ()
    if units:
        yield tr("systemd also {verb}s {some}.", verb=tr(verb), some=some(units))
    for other in rows.values():
        if name in other.needs and other.state(now) not in ENDED:
            yield tr("{name} needs it, and is {state}.", name=other.name, state=tr(other.state(now).value))
