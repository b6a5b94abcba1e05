"""Routines as lines: problems, the timeline, the progress of a robot, what has just changed."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from fleet_tui.model.routines.blocks import LanePlan, RoutineProblem
from fleet_tui.model.routines.lane import Gate, Lane, LaneNote, LanePhase
from fleet_tui.rules.routines.positions import block_at
from fleet_tui.rules.routines.timeline import TimelineEntry
from fleet_tui.text.durations import age
from fleet_tui.text.sanitize import sanitize

HELD, PAUSED, WAITING, RUNNING = "held", "paused", "waiting", "running"


def problem_line(name: str, problem: RoutineProblem) -> str:
    """Return a problem with its place."""
    return sanitize(f"{name}, line {problem.line}: {problem.text}")


def timeline_lines(entries: Sequence[TimelineEntry]) -> Iterator[str]:
    """Yield the timelines of all robots: minutes and seconds from the start, `>=` for a lower limit."""
    for robot, of_robot in groupby(entries, lambda entry: entry.robot):
        yield sanitize(f"{robot}:")
        for entry in of_robot:
            at = f"{'>=' if entry.is_least else ''}{int(entry.at) // 60}:{int(entry.at) % 60:02}"
            lasts = "" if entry.seconds is None else f"about {age(entry.seconds)}"
            notes = ", ".join(part for part in (lasts, entry.note) if part)
            yield sanitize(f"{at:>8}  line {entry.line:<4} {entry.text}" + (f" ({notes})" if notes else ""))


def lane_word(lane: Lane) -> str:
    """Return the state of a lane in a word."""
    if lane.is_over:
        return lane.phase.value
    gates = {Gate.HELD: HELD, Gate.PAUSED: PAUSED}
    return gates.get(lane.gate) or (WAITING if lane.phase is LanePhase.WAITING else RUNNING)


def lane_text(plan: LanePlan, lane: Lane) -> str:
    """Return the current instruction of a lane, and the reason of a hold or a failure."""
    block = None if lane.is_over else block_at(plan, lane.path)
    at = f"line {block.line}: {block.text}" if block is not None else ""
    goes_on = lane_word(lane) in (HELD, PAUSED) and lane.phase is LanePhase.ORDERED
    shows = lane.has_failed or lane.gate is Gate.HELD
    parts = (at, "its order goes on" * goes_on, lane.detail if shows else "")
    return sanitize("; ".join(part for part in parts if part))


def note_text(note: LaneNote) -> str:
    """Return a change of a lane in words."""
    where = f"line {note.line}: {note.text}: " if note.line else ""
    return sanitize(f"{where}{note.change}" + (f": {note.detail}" if note.detail else ""))


def summary_word(lanes: Sequence[Lane]) -> str:
    """Return the state of a whole routine: that which needs a person first."""
    words = [lane_word(lane) for lane in lanes]
    order = (HELD, "failed", PAUSED, RUNNING, WAITING, "stopped", "done")
    return next((word for word in order if word in words), "done")
