"""The activities of robots, as an SVG picture: a row for each, a bar for each activity."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import groupby
from xml.etree.ElementTree import Element

from fleet_tui.features.history.report.axis import LocalTime, axis
from fleet_tui.features.history.report.html import element
from fleet_tui.model.history.facts import Activity
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.timeline import Shares, Timeline

WIDTH = 960.0
LEFT = 96.0
ROW = 18.0
FOOT = 18.0
HIGH = 15.0
"""Of the highest bar, and of a column of the whole time."""
HEIGHTS: Mapping[Activity, float] = {
    Activity.DRIVING: 11.0,
    Activity.LOADING: 8.0,
    Activity.WAITING: 5.0,
    Activity.CHARGING: 3.0,
    Activity.IDLE: 1.0,
    Activity.PAUSED: 7.0,
    Activity.BLOCKED: HIGH,
    Activity.OFFLINE: HIGH,
}
"""Height of each bar, so that no meaning is in a colour alone: trouble is as high as its row."""


Draw = Callable[[float], list[Element]]
"""Draws a row around its middle."""


def timeline(rows: Timeline, time: Division, local: LocalTime) -> Element:
    """Return the picture of a shift."""
    bars = {robot: partial(_bars, does, time.parts) for robot, does in rows.items()}
    return _picture(bars, time, local)


def share_picture(rows: Shares, time: Division, local: LocalTime) -> Element:
    """Return the picture of days, whose parts are too long for a single activity."""
    columns = {robot: partial(_columns, shares, time.parts) for robot, shares in rows.items()}
    return _picture(columns, time, local)


def _picture(rows: Mapping[str, Draw], time: Division, local: LocalTime) -> Element:
    height = ROW * len(rows)
    children = axis(time, local, LEFT, WIDTH - LEFT, height)
    for n, (robot, draw) in enumerate(rows.items()):
        middle = ROW * (n + 0.5)
        children.append(element("text", _short(robot), x=LEFT - 6, y=middle + 4, text_anchor="end"))
        children += draw(middle)
    viewbox = f"0 0 {WIDTH:g} {height + FOOT:g}"
    return element("svg", *children, viewBox=viewbox, class_="timeline", role="img")


def legend() -> Element:
    """Return the bar of each activity with its name."""
    entries = []
    for activity, height in HEIGHTS.items():
        bar = element("path", d="M0,8h22", stroke_width=height, class_=activity.value)
        entries.append(element("span", element("svg", bar, viewBox="0 0 22 16"), activity.value))
    return element("p", *entries, class_="legend")


def _bars(does: Sequence[Activity | None], parts: int, middle: float) -> list[Element]:
    """Return one path for each activity: a robot's row is as small as its changes are few."""
    part, at = (WIDTH - LEFT) / parts, 0
    paths: dict[Activity, list[str]] = {}
    for activity, same in groupby(does):
        count = len(list(same))
        if activity is not None:
            paths.setdefault(activity, []).append(f"M{LEFT + part * at:.1f},{middle:g}h{part * count:.1f}")
        at += count
    return [
        element("path", d="".join(bars), stroke_width=HEIGHTS[activity], class_=activity.value)
        for activity, bars in paths.items()
    ]


def _columns(shares: Sequence[tuple[float, float] | None], parts: int, middle: float) -> list[Element]:
    """Return the shares of work as columns from below, and those of trouble as columns from above."""
    part, top = (WIDTH - LEFT) / parts, middle - HIGH / 2
    work, trouble, watched = [], [], []
    for n, share in enumerate(shares):
        if share is not None:
            x = f"M{LEFT + part * (n + 0.5):.1f},"
            work.append(f"{x}{top + HIGH:g}v{-HIGH * share[0]:.1f}" if share[0] > 0 else "")
            trouble.append(f"{x}{top:g}v{HIGH * share[1]:.1f}" if share[1] > 0 else "")
            watched.append(f"M{LEFT + part * n:.1f},{top + HIGH:g}h{part:.1f}")
    return [
        element("path", d="".join(watched), stroke_width=0.5, class_="idle"),
        element("path", d="".join(work), stroke_width=part, class_=Activity.DRIVING.value),
        element("path", d="".join(trouble), stroke_width=part, class_=Activity.BLOCKED.value),
    ]


def _short(name: str) -> str:
    return name if len(name) <= 14 else f"{name[:6]}…{name[-7:]}"
