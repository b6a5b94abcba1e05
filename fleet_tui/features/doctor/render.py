"""Findings as text and as JSON. The schema is in docs/doctor.md."""

import textwrap
from collections import Counter
from collections.abc import Sequence
from typing import Any

from fleet_tui.links.discovery.finding import Finding, Verdict, listed
from fleet_tui.text.sanitize import sanitize

VERSION = 1
GLYPHS = {Verdict.OK: "✓", Verdict.WARN: "!", Verdict.FAIL: "✗", Verdict.SKIPPED: "-"}
PLAIN = {**GLYPHS, Verdict.OK: "+", Verdict.FAIL: "x"}
COLOURS = {Verdict.OK: "32", Verdict.WARN: "33", Verdict.FAIL: "1;31", Verdict.SKIPPED: "2"}
_INDENT = " " * 10


def line(finding: Finding, plain: bool, colour: bool, width: int = 0) -> str:
    """Return one finding: verdict, glyph, subject, measurement, remedy. `width` 0: all on one line."""
    verdict = f"{finding.verdict.value:>7} {(PLAIN if plain else GLYPHS)[finding.verdict]}"
    message = f"{finding.subject} {finding.check}: {finding.measured}"
    message = sanitize(f"{message} -> {finding.remedy}" if finding.remedy else message)
    if plain:
        message = message.encode("ascii", "replace").decode()
    if width:
        wrapped = textwrap.wrap(message, max(width - len(_INDENT), 20), break_on_hyphens=False)
        message = f"\n{_INDENT}".join(wrapped)
    if colour:
        verdict = f"\x1b[{COLOURS[finding.verdict]}m{verdict}\x1b[m"
    return f"{verdict} {message}"


def summary(findings: Sequence[Finding], width: int = 0) -> str:
    """Return the last line: the number of each verdict, and the first to look at."""
    counts = Counter(finding.verdict for finding in findings)
    text = ", ".join(f"{counts[verdict]} {verdict.value}" for verdict in Verdict if counts[verdict])
    first = next((finding for finding in findings if finding.is_failure), None)
    warned = [f"{one.subject} {one.check}" for one in findings if one.verdict is Verdict.WARN]
    if first is not None:
        text = f"{text}. Start with {first.subject} {first.check}: {first.measured}"
    elif warned:
        text = f"{text}: {listed(warned)}"
    text = sanitize(text + _left_out(findings))
    return "\n".join(textwrap.wrap(text, width, break_on_hyphens=False)) if width else text


def _left_out(findings: Sequence[Finding]) -> str:
    left = [finding.subject for finding in findings if finding.out_of_time]
    if not left:
        return ""
    whose = listed(dict.fromkeys(left))
    return f". Out of time, not run: {len(left)} checks of {whose}: use a longer --timeout or --robot"


def as_values(findings: Sequence[Finding], wall: float, code: int) -> dict[str, Any]:
    """Return the values for `doctor --json`."""
    first = next((finding for finding in findings if finding.is_failure), None)
    return {
        "version": VERSION,
        "time": wall,
        "exit_code": code,
        "counts": {
            verdict.value.lower(): sum(finding.verdict is verdict for finding in findings)
            for verdict in Verdict
        },
        "first": None if first is None else _values(first),
        "findings": [_values(finding) for finding in findings],
    }


def _values(finding: Finding) -> dict[str, Any]:
    return {
        "subject": finding.subject,
        "check": finding.check,
        "verdict": finding.verdict.value.lower(),
        "measured": finding.measured,
        "remedy": finding.remedy or None,
        "values": dict(finding.values),
    }
