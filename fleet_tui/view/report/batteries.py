"""Battery curves of robots, one small SVG picture each."""

from collections.abc import Mapping, Sequence
from xml.etree.ElementTree import Element

from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.view.report.html import element

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
