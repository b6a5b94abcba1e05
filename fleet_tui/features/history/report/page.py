"""The page: what the next shift needs first, then figures and pictures."""

from collections.abc import Callable, Mapping, Sequence
from xml.etree.ElementTree import Element, tostring

from fleet_tui.features.history.report.content import ReportContent
from fleet_tui.features.history.report.heat import heat
from fleet_tui.features.history.report.html import element, table
from fleet_tui.features.history.report.timeline import legend, share_picture, timeline
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.records.history.shift import OrderCounts
from fleet_tui.text.units import age

WIDTH = 150.0
HEIGHT = 50.0


def batteries(charges: Mapping[str, Sequence[ChargeTotal]], parts: int, low: float) -> Element:
    """Return a figure for each robot; `low` is the limit in per cent, a line in each."""
    return element("div", *(_figure(name, one, parts, low) for name, one in charges.items()), class_="small")


def _figure(name: str, charges: Sequence[ChargeTotal], parts: int, low: float) -> Element:
    last, lowest = charges[-1].last, min(one.low for one in charges)
    limit = element("path", d=f"M0,{_y(low):.1f}H{WIDTH:g}", class_="limit")
    curve = element("path", d=_curve(charges, parts), class_="curve")
    picture = element("svg", limit, curve, viewBox=f"0 0 {WIDTH:g} {HEIGHT:g}", role="img")
    return element(
        "figure", picture, element("figcaption", element("b", name), f" {last:.0f} %, lowest {lowest:.0f} %")
    )


def _curve(charges: Sequence[ChargeTotal], parts: int) -> str:
    """Return the lines through the last level of each part; a part that nobody saw is a gap."""
    steps, before = [], -2
    for one in charges:
        pen = "L" if one.part == before + 1 else "M"
        steps.append(f"{pen}{WIDTH * (one.part + 0.5) / parts:.1f},{_y(one.last):.1f}")
        if pen == "M":
            steps.append("h.5")  # a part alone is a dot
        before = one.part
    return "".join(steps)


def _y(percent: float) -> float:
    return HEIGHT - HEIGHT * min(100.0, max(0.0, percent)) / 100.0


CSS = """
:root { color-scheme: light; }
body { font: 14px/1.45 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1d2733; background: #fff;
  max-width: 1000px; margin: 24px auto; padding: 0 20px; }
h1 { font-size: 24px; margin: 0 0 2px; }
h2 { font-size: 16px; margin: 28px 0 8px; border-bottom: 1px solid #cfd6de; padding-bottom: 3px; }
.about, figcaption, .legend, .none { color: #56616d; }
.warning { background: #fff4d6; border-left: 4px solid #c98a00; padding: 6px 10px; }
.tiles { display: flex; flex-wrap: wrap; gap: 8px; margin: 16px 0; }
.tiles div { flex: 1 1 110px; border: 1px solid #cfd6de; border-radius: 6px; padding: 8px 10px; }
.tiles b { display: block; font-size: 22px; line-height: 1.2; }
.tiles .bad b::before { content: "\\25b2\\00a0"; font-size: 15px; }
.tiles .bad b { color: #a61b1b; }
.notes p { border-left: 4px solid #2f6fb3; margin: 6px 0; padding: 2px 10px; white-space: pre-wrap;
  overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 8px; border-bottom: 1px solid #e6eaee; overflow-wrap: anywhere; }
th { color: #56616d; font-weight: 600; }
.n { text-align: right; white-space: nowrap; overflow-wrap: normal; }
svg { display: block; width: 100%; height: auto; }
svg text { font: 11px system-ui, "DejaVu Sans", sans-serif; fill: #3a4552; }
.mark { stroke: #e1e6eb; fill: none; }
.driving { stroke: #2e8b57; } .loading { stroke: #2f6fb3; } .waiting { stroke: #b8860b; }
.charging { stroke: #1f9aa8; } .idle { stroke: #8a95a1; } .paused { stroke: #7d5bb5; }
.blocked { stroke: #c22f2f; } .offline { stroke: #59626c; stroke-dasharray: 1.5 1.5; }
.legend span { display: inline-flex; align-items: center; gap: 5px; margin-right: 14px; }
.legend svg { width: 22px; height: 16px; }
.small { display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 10px; }
figure { margin: 0; } .small svg { border: 1px solid #e1e6eb; }
.curve { stroke: #1f6f5c; stroke-width: 1.5; fill: none; stroke-linejoin: round; }
.limit { stroke: #c22f2f; stroke-width: .7; stroke-dasharray: 3 3; fill: none; }
.floors { display: grid; grid-template-columns: repeat(auto-fit, minmax(380px, 1fr)); gap: 14px; }
.floor { border: 1px solid #cfd6de; max-height: 520px; }
.heat { fill: #d1341f; fill-opacity: .45; stroke: #8f1d0d; stroke-width: 1; }
.floor text { font-size: inherit; fill: #5c1207; font-weight: 600; }
@page { size: A4; margin: 14mm; }
@media print { body { margin: 0; max-width: none; padding: 0; font-size: 11px; }
  h2 { break-after: avoid; } tr, figure, .tiles div { break-inside: avoid; }
  thead { display: table-header-group; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
"""


MOST_ROWS = 40
"""Rows of a table of single orders, commands or routes; of more the rest is counted."""

ACTIVITIES = (Activity.DRIVING, Activity.BLOCKED, Activity.PAUSED, Activity.OFFLINE)


def page(content: ReportContent) -> str:
    """Return the whole document. It fetches nothing and runs nothing."""
    title = f"{content.site}: {_span(content)}"
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="viewport", content="width=device-width"),
        # Whatever stands in a name or a note: nothing is run, nothing is fetched.
        element(
            "meta",
            http_equiv="Content-Security-Policy",
            content="default-src 'none'; style-src 'unsafe-inline'; img-src data:",
        ),
        element("title", title),
        _style(),
    )
    parts = [part for section in SECTIONS for part in section(content)]
    body = element("body", *_opening(content), *parts)
    document = element("html", head, body, lang="en")
    return f"<!DOCTYPE html>\n{tostring(document, encoding='unicode', method='html')}\n"


def _style() -> Element:
    style = Element("style")
    style.text = CSS  # its own text: nothing to sanitize
    return style


def _span(content: ReportContent) -> str:
    return f"{content.local.moment(content.since, True)} to {content.local.moment(content.until, True)}"


def _opening(content: ReportContent) -> list[Element]:
    about = f"{_span(content)} ({age(content.until - content.since)}), made by {content.made_by}"
    opening = [element("h1", content.site), element("p", about, class_="about")]
    if content.begun is not None:
        begins = f"Nobody watched before {content.local.moment(content.begun, True)}."
        opening.append(element("p", begins, class_="warning"))
    if content.unwatched:
        opening.append(element("p", content.unwatched, class_="warning"))
    return opening


def _notes(content: ReportContent) -> list[Element]:
    told = [
        element("p", f"{content.local.moment(note.at, False)} {note.operator}: {note.text}")
        for note in content.notes
    ]
    none = element("p", "No notes. An operator writes one with :note TEXT.", class_="none")
    return [element("h2", "Notes"), element("div", *(told or [none]), class_="notes")]


def _handover(content: ReportContent) -> list[Element]:
    """Return what the next shift takes over, each by name."""
    local, going_on = content.local, content.handover
    orders = [
        [
            order.robot,
            order.order,
            *_ends(order.way),
            order.stage,
            local.moment(order.begun or order.queued, False),
            order.operator or "another client",
        ]
        for order in going_on.orders
    ]
    alarms = [
        [
            alarm.source,
            alarm.kind,
            alarm.priority,
            alarm.text,
            local.moment(alarm.raised, False),
            "over" if alarm.returned is not None else "holds",
            alarm.operator or "nobody",
        ]
        for alarm in going_on.alarms
    ]
    claims = [[claim.robot, claim.operator, claim.host] for claim in going_on.claims]
    order_heads = ["Robot", "Order", "From", "To", "State", "Since", "By"]
    alarm_heads = ["Robot, link", "Alarm", "Priority", "Text", "Since", "State", "Acknowledged by"]
    unknown = going_on.claims_unknown
    return [
        element("h2", "Handed over: open orders"),
        *(_capped(order_heads, orders, 9) or [_none("No order is open.")]),
        element("h2", "Handed over: open alarms"),
        *(_capped(alarm_heads, alarms, 9) or [_none("No alarm is open.")]),
        element("h2", "Handed over: claimed robots"),
        *([element("p", f"Claims unknown: {unknown}", class_="warning")] if unknown else []),
        *(_capped(["Robot", "By", "Console"], claims, 9) or [_none("No robot is claimed.")] * (not unknown)),
    ]


def _ends(way: str) -> tuple[str, str]:
    """Return the first and the last stop of a way; one to a single stop begins at the robot."""
    start, arrow, _ = way.partition(" -> ")
    return (start, way.rpartition(" -> ")[2]) if arrow else ("", way.removeprefix("-> "))


def _capped(heads: Sequence[str], rows: Sequence[Sequence[str]], texts: int) -> list[Element]:
    return [table(heads, rows[:MOST_ROWS], texts), *_more(rows)] if rows else []


def _tiles(content: ReportContent) -> list[Element]:
    counts = [robot.orders for robot in content.robots]
    lost = sum(one.lost for one in counts)
    down = sum(robot.down for robot in content.robots)
    alarms = sum(cause.count for cause in content.causes)
    tiles = [
        ("done", sum(one.done for one in counts), False),
        ("of these late", sum(one.late for one in counts), False),
        ("lost or failed", lost, lost > 0),
        ("left the queue", sum(one.left for one in counts), False),
        ("cancelled", sum(one.cancelled for one in counts), False),
        ("still open", len(content.handover.orders), False),
        ("alarms", alarms, False),
    ]
    made = [_tile(name, f"{value:,}", is_bad) for name, value, is_bad in tiles]
    made.append(_tile("downtime of all robots", age(down), False))
    return [element("h2", "Orders and trouble"), element("div", *made, class_="tiles")]


def _tile(name: str, value: str, is_bad: bool) -> Element:
    return element("div", element("b", value), name, class_="bad" if is_bad else "")


def _robots(content: ReportContent) -> list[Element]:
    heads = [
        "Robot",
        "Done",
        "Late",
        "Lost",
        "Left",
        "Cancelled",
        *(one.value.capitalize() for one in ACTIVITIES),
    ]
    rows = [
        [
            robot.name,
            *_counts(robot.orders),
            *(_seconds(robot.seconds.get(activity, 0.0)) for activity in ACTIVITIES),
            _percent(robot.last),
            _percent(robot.low),
            _seconds(robot.watched),
        ]
        for robot in content.robots
    ]
    title = element("h2", "Robots")
    return [
        title,
        table([*heads, "Battery", "Lowest", "Watched"], rows) if rows else _none("No robot was seen."),
    ]


def _counts(counts: OrderCounts) -> list[str]:
    shown = (counts.done, counts.late, counts.lost, counts.left, counts.cancelled)
    return [str(value or "") for value in shown]


def _timeline(content: ReportContent) -> list[Element]:
    title, each = element("h2", "What the robots did"), age(content.time.step)
    axes = content.time, content.local
    if content.timeline:
        said = (
            f"Each bar is what a robot did for most of {each}. Blank: nobody watched, or its link was lost."
        )
        picture = timeline(content.timeline, *axes)
        return [title, element("p", said, class_="about"), legend(), picture]
    if content.shares:
        said = (
            f"Each column is {each}: from below the part in which a robot was driving or loading, from above,"
            " red, the part in which it was blocked, paused or offline. Without a line: nobody watched, or"
            " its link was lost."
        )
        return [title, element("p", said, class_="about"), share_picture(content.shares, *axes)]
    return []


def _routes(content: ReportContent) -> list[Element]:
    ways = sorted(content.routes.items(), key=lambda item: (-item[1].lost, -item[1].late, -item[1].done))
    rows = [
        [way, *_counts(counts), _seconds(counts.mean or 0.0), _seconds(counts.longest)]
        for way, counts in ways[:MOST_ROWS]
    ]
    heads = ["Route", "Done", "Late", "Lost", "Left", "Cancelled", "Usual time", "Longest"]
    said = "Late: took more than twice the mean time of its route, of which at least three were done."
    return [
        element("h2", "Routes"),
        *([table(heads, rows), *_more(ways)] if rows else [_none("No order ended.")]),
        element("p", said, class_="about"),
    ]


def _alarms(content: ReportContent) -> list[Element]:
    rows = [
        [
            cause.kind,
            cause.priority,
            str(cause.count),
            str(cause.sources),
            _seconds(cause.seconds),
            _seconds(cause.longest),
            "" if cause.until_seen is None else age(cause.until_seen),
        ]
        for cause in content.causes
    ]
    heads = ["Alarm", "Priority", "Times", "Robots, links", "Held in all", "Longest", "Seen after"]
    return [element("h2", "Alarms by cause"), table(heads, rows, 2) if rows else _none("No alarm.")]


def _links(content: ReportContent) -> list[Element]:
    rows = [[name, str(count), _seconds(seconds)] for name, (count, seconds) in content.outages.items()]
    return [element("h2", "Links"), table(["Link", "Lost", "Down"], rows)] if rows else []


def _batteries(content: ReportContent) -> list[Element]:
    if not content.charges:
        return []
    pictures = batteries(content.charges, content.time.parts, content.battery_low)
    said = element("p", f"Dashed: {content.battery_low:.0f} %, the limit of an alarm.", class_="about")
    return [element("h2", "Batteries"), said, pictures]


def _floors(content: ReportContent) -> list[Element]:
    title = element("h2", "Where robots were blocked")
    pictures = [heat(floor) for floor in content.floors]
    return [title, element("div", *pictures, class_="floors") if pictures else _none("No robot was blocked.")]


def _losses(content: ReportContent) -> list[Element]:
    rows = [
        [
            content.local.moment(order.ended or order.queued, False),
            order.robot,
            order.way,
            order.stage,
            order.reason,
        ]
        for order in content.losses[-MOST_ROWS:]
    ]
    heads = ["Time", "Robot", "Order", "End", "Reason"]
    title = element("h2", "Orders that were lost, failed or left the queue")
    return [title, table(heads, rows, 9), *_more(content.losses)] if rows else []


def _refusals(content: ReportContent) -> list[Element]:
    rows = [
        [
            content.local.moment(command.at, False),
            command.operator,
            command.robot,
            f"{command.what} {command.way}".strip(),
            command.stage,
            command.reason,
        ]
        for command in content.refusals[-MOST_ROWS:]
    ]
    heads = ["Time", "Operator", "Robot", "Command", "Outcome", "Reason"]
    title = element("h2", "Commands that failed")
    return [title, table(heads, rows, 9), *_more(content.refusals)] if rows else []


SECTIONS: Sequence[Callable[[ReportContent], list[Element]]] = (
    _notes,
    _handover,
    _tiles,
    _robots,
    _timeline,
    _losses,
    _routes,
    _alarms,
    _links,
    _batteries,
    _floors,
    _refusals,
)


def _more(rows: Sequence[object]) -> list[Element]:
    more = len(rows) - MOST_ROWS
    return [element("p", f"and {more:,} more", class_="none")] if more > 0 else []


def _none(text: str) -> Element:
    return element("p", text, class_="none")


def _seconds(seconds: float) -> str:
    return age(seconds) if seconds >= 0.5 else ""


def _percent(level: float | None) -> str:
    return "" if level is None else f"{level:.0f} %"
