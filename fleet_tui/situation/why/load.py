"""What an overloaded bridge carries: the topics with most messages, those of all robots together."""

from collections import defaultdict

from fleet_tui.model.counters import LinkCounter
from fleet_tui.situation.why.reason import Reason, Strength
from fleet_tui.text.language import Message, counted, joined
from fleet_tui.text.units import size_text

NAMED = 3
"""Kinds of topics that are named."""


def busiest(counter: LinkCounter, now: float) -> Reason | None:
    """Return the topics that arrive most often as the reason of a late bridge, None before any rate is
    known."""
    found: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for topic in counter.topics.values():
        if (rates := topic.rates(now)) is not None and rates[0] > 0.0:
            found[topic.kind or topic.topic].append(rates)
    if not found:
        return None
    sums = {kind: (len(all_), *map(sum, zip(*all_, strict=True))) for kind, all_ in found.items()}
    first = sorted(sums.items(), key=lambda one: -one[1][1])[:NAMED]
    told = joined(
        ", ",
        (
            counted(
                "{kind} {rate}/s, {size}/s in {count} topic",
                "{kind} {rate}/s, {size}/s in {count} topics",
                int(count),
                kind=kind,
                rate=f"{messages:.0f}",
                size=size_text(int(size)),
            )
            for kind, (count, messages, size) in first
        ),
    )
    name = Message("most messages: {kind}", kind=joined(", ", (kind for kind, _ in first)))
    return Reason(name, told, Strength.LIKELY, keys=("diagnostics",))
