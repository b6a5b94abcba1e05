"""Routines as lines: problems, the timeline, the progress of a robot, what has just changed."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from fleet_tui.features.routines.blocks import LanePlan, RoutineProblem
from fleet_tui.features.routines.lane import Gate, Lane, LaneNote, LanePhase
from fleet_tui.features.routines.row import RoutineRow
from fleet_tui.features.routines.rules.positions import block_at
from fleet_tui.features.routines.rules.timeline import TimelineEntry
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age

HELD = Message("held")
PAUSED = Message("paused")
WAITING = Message("waiting")
RUNNING = Message("running")
NEVER = Message("never run")


def problem_line(name: str, problem: RoutineProblem) -> str:
    """Return a problem with its place."""
    return sanitize(
        tr("{name}, line {line}: {text}", name=name, line=problem.line, text=translate(problem.text))
    )


def timeline_lines(entries: Sequence[TimelineEntry]) -> Iterator[str]:
    """Yield the timelines of all robots: minutes and seconds from the start, `>=` for a lower limit."""
    for robot, of_robot in groupby(entries, lambda entry: entry.robot):
        yield sanitize(f"{robot}:")
        for entry in of_robot:
            at = _clock(entry.at, entry.is_least)
            lasts = "" if entry.seconds is None else tr("about {age}", age=age(entry.seconds))
            notes = ", ".join(part for part in (lasts, translate(entry.note)) if part)
            yield sanitize(
                f"{at:>8}  "
                + tr("line {line} {text}", line=f"{entry.line:<4}", text=entry.text)
                + (f" ({notes})" if notes else "")
            )


def timeline_totals(entries: Sequence[TimelineEntry]) -> Iterator[str]:
    """Yield the number of instructions of each robot, and the time of the last one's end."""
    for robot, of_robot in groupby(entries, lambda entry: entry.robot):
        found = list(of_robot)
        last = found[-1]
        how = tr("at least") if last.is_least or last.seconds is None else tr("about")
        ends = _clock(last.at + (last.seconds or 0.0), False)
        total = counted(
            "{robot}: {count} instruction, {how} {ends} min",
            "{robot}: {count} instructions, {how} {ends} min",
            len(found),
            robot=robot,
            how=how,
            ends=ends,
        )
        yield sanitize(translate(total))


def _clock(seconds: float, is_least: bool) -> str:
    return f"{'>=' if is_least else ''}{int(seconds) // 60}:{int(seconds) % 60:02}"


def lane_word(lane: Lane) -> Message:
    if lane.is_over:
        return Message(lane.phase.value)
    gates = {Gate.HELD: HELD, Gate.PAUSED: PAUSED}
    return gates.get(lane.gate) or (WAITING if lane.phase is LanePhase.WAITING else RUNNING)


def lane_text(plan: LanePlan, lane: Lane) -> str:
    """Return the current instruction of a lane, and the reason of a hold or a failure."""
    block = None if lane.is_over else block_at(plan, lane.path)
    at = tr("line {line}: {text}", line=block.line, text=block.text) if block is not None else ""
    goes_on = lane_word(lane) in (HELD, PAUSED) and lane.phase is LanePhase.ORDERED
    shows = lane.has_failed or lane.gate is Gate.HELD
    parts = (at, tr("its order continues") * goes_on, translate(lane.detail) if shows else "")
    return sanitize("; ".join(part for part in parts if part))


def note_text(note: LaneNote) -> str:
    """Return a change of a lane in words."""
    where = tr("line {line}: {text}: ", line=note.line, text=note.text) if note.line else ""
    return sanitize(where + translate(note.change) + (f": {translate(note.detail)}" if note.detail else ""))


def row_word(row: RoutineRow) -> Message:
    """Return the state of a routine in the list."""
    if not row.lanes:
        return NEVER
    return HELD if row.is_left else summary_word(row.lanes)


def summary_word(lanes: Sequence[Lane]) -> Message:
    """Return the state of a whole routine: that which needs a person first."""
    words = [lane_word(lane) for lane in lanes]
    order = (HELD, Message("failed"), PAUSED, RUNNING, WAITING, Message("stopped"), Message("done"))
    return next((word for word in order if word in words), Message("done"))
