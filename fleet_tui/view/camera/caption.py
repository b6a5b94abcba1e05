"""The line above a picture of a camera, and the text in the place of a missing one."""

from typing import NamedTuple

from fleet_tui.text.durations import age
from fleet_tui.text.sanitize import sanitize

OLD, GONE = 2.0, 10.0
"""Seconds after which a picture is marked as old, and is not shown any more."""


class Facts(NamedTuple):
    """What is known of a camera. `size` in pixels, (0, 0) before the first picture; `seconds` since it was
    taken, None before the first; `problem`: the reason that there is none; `rate` in words."""

    robot: str
    size: tuple[int, int] = (0, 0)
    seconds: float | None = None
    rate: str = ""
    problem: str = ""


def caption(facts: Facts) -> tuple[str, bool]:
    """Return robot, size, age and rate, and whether that is a warning."""
    parts = [f"Camera of {sanitize(facts.robot)}"]
    if facts.size != (0, 0):
        parts.append(f"{facts.size[0]}x{facts.size[1]}")
    is_old = facts.seconds is not None and facts.seconds > OLD
    if facts.seconds is not None:
        parts.append(f"old: {age(facts.seconds)}" if is_old else age(facts.seconds))
        parts.append(facts.rate)
    return "  ".join(filter(None, parts)), is_old or bool(facts.problem)


def note(facts: Facts) -> str:
    """Return the text in the place of the picture, empty if it is shown."""
    if facts.problem:
        return f"no picture: {facts.problem}"
    if facts.seconds is None:
        return "waiting for the first picture"
    return f"no picture for {age(facts.seconds)}" if facts.seconds > GONE else ""
