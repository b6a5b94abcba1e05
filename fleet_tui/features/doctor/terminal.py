"""Findings about the terminal: size, colours, glyphs, locale, speed."""

import locale
import os
import select
import sys
import termios
import time
import tty
from collections.abc import Iterator, Mapping

from fleet_tui.links.discovery.finding import Finding, Verdict

TERMINAL = "terminal"
ASK_PLACE = b"\x1b[6n"  # cursor position report: answered when all earlier output is processed
PATIENCE = 1.0
# Output for measuring the speed: invisible resets.
NOTHING = b"\x1b[0m" * 8192
SLOW = 50_000  # bytes per second; a picture of the console takes a few thousand
BRAILLE = "⣿⣿"
MULTIPLEXERS = {"tmux": "TMUX", "screen": "STY"}


def terminal_findings() -> Iterator[Finding]:
    """Return everything about the terminal; nothing if the output is not one."""
    if not sys.stdout.isatty():
        return
    size = os.get_terminal_size(sys.stdout.fileno())
    yield size_finding(size.columns, size.lines)
    yield colour_finding(os.environ)
    yield locale_finding(sys.stdout.encoding, locale.setlocale(locale.LC_CTYPE))
    if sys.stdin.isatty():
        yield from measured_findings(sys.stdin.fileno(), sys.stdout.fileno())


def size_finding(columns: int, rows: int) -> Finding:
    """Judge whether the console fits."""
    measured, values = f"{columns} x {rows}", {"columns": columns, "rows": rows}
    if columns < 60 or rows < 16:
        return Finding(
            TERMINAL,
            "size",
            Verdict.WARN,
            f"{measured}: plain list only",
            "enlarge it to 80 x 24 or more",
            values,
        )
    small = "" if columns >= 120 else ": side by side from 120 columns on"
    return Finding(TERMINAL, "size", Verdict.OK, measured + small, values=values)


def colour_finding(environment: Mapping[str, str]) -> Finding:
    """Judge the number of colours, by the environment."""
    term, more = environment.get("TERM", ""), environment.get("COLORTERM", "")
    values = {"TERM": term, "COLORTERM": more}
    if environment.get("NO_COLOR"):
        return Finding(TERMINAL, "colours", Verdict.OK, "none: NO_COLOR is set", values=values)
    if not term or term in ("dumb", "unknown", "vt100", "vt102", "vt220"):
        remedy = "set TERM to the terminal's type, e.g. xterm-256color"
        return Finding(
            TERMINAL, "colours", Verdict.WARN, f"none: TERM is {term or 'not set'}", remedy, values
        )
    if more in ("truecolor", "24bit") or "direct" in term:
        count = "16 million"
    else:
        count = "256" if "256" in term else "16"
    return Finding(TERMINAL, "colours", Verdict.OK, f"{count} (TERM {term})", values=values)


def locale_finding(encoding: str, name: str) -> Finding:
    """Judge whether letters and glyphs are sent as UTF-8."""
    measured = f"{encoding}, LC_CTYPE {name}"
    if encoding.lower().replace("-", "") == "utf8":
        return Finding(TERMINAL, "locale", Verdict.OK, measured)
    return Finding(TERMINAL, "locale", Verdict.WARN, measured, "export LC_ALL=C.UTF-8: else the map is ASCII")


def measured_findings(keys: int, screen: int) -> Iterator[Finding]:
    """Judge glyphs and speed, by asking the terminal for its cursor position."""
    before = termios.tcgetattr(keys)
    try:
        tty.setcbreak(keys)
        found = _measured(keys, screen)
    finally:
        termios.tcsetattr(keys, termios.TCSADRAIN, before)
    if found is None:
        silent = f"no cursor position report within {PATIENCE:g} s"
        yield Finding(TERMINAL, "glyphs", Verdict.SKIPPED, silent)
        yield Finding(TERMINAL, "speed", Verdict.SKIPPED, silent)
        return
    cells, rate, answer = found
    yield glyph_finding(cells)
    inside = next((name for name, mark in MULTIPLEXERS.items() if os.environ.get(mark)), "")
    yield speed_finding(rate, answer, inside)


def _measured(keys: int, screen: int) -> tuple[int, float, float] | None:
    """Return the cells of the braille text, bytes per second, seconds of an answer."""
    os.write(screen, b"\r")
    start = _place(keys, screen)
    if start is None:
        return None
    os.write(screen, BRAILLE.encode())
    end = _place(keys, screen)
    os.write(screen, b"\r\x1b[K")
    began = time.monotonic()
    _place(keys, screen)
    answer = time.monotonic() - began
    os.write(screen, NOTHING)
    last = _place(keys, screen)
    if end is None or last is None:
        return None
    took = time.monotonic() - began - answer
    return end - start, len(NOTHING) / max(took - answer, 1e-6), answer


def glyph_finding(cells: int) -> Finding:
    """Judge whether braille has the expected width."""
    values = {"cells": cells, "of": len(BRAILLE)}
    if cells == len(BRAILLE):
        return Finding(TERMINAL, "glyphs", Verdict.OK, "braille characters are one cell wide", values=values)
    remedy = "set a UTF-8 locale on both ends, or start with --drawing ascii"
    wide = f"{len(BRAILLE)} braille characters are {cells} cells wide"
    return Finding(TERMINAL, "glyphs", Verdict.WARN, wide, remedy, values)


def speed_finding(rate: float, answer: float, inside: str = "") -> Finding:
    """Judge the output speed, bytes per second, and the echo time of a key. `inside` a multiplexer that is
    measured, not the terminal behind it."""
    values = {"bytes_per_s": round(rate), "answer_s": round(answer, 4)}
    by = f" (measured to {inside}, not to the display)" if inside else ""
    measured = f"{rate / 1000:,.0f} kB/s, response {answer * 1000:.1f} ms{by}"
    if rate < SLOW:
        remedy = 'set [ui] ticks_per_second = 2, drawing = "ascii"'
        return Finding(TERMINAL, "speed", Verdict.WARN, measured, remedy, values)
    return Finding(TERMINAL, "speed", Verdict.OK, measured, values=values)


def _place(keys: int, screen: int) -> int | None:
    """Return the column of the cursor, None if the terminal does not report it."""
    os.write(screen, ASK_PLACE)
    answer, until = b"", time.monotonic() + PATIENCE
    while b"R" not in answer:
        if not select.select([keys], [], [], max(0.0, until - time.monotonic()))[0]:
            return None
        answer += os.read(keys, 64)
    digits = answer.rpartition(b"R")[0].rpartition(b";")[2]
    return int(digits) if digits.isdigit() else None
