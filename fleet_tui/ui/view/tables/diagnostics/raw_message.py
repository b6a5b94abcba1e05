"""A raw message for reading: JSON with indents, long lists visibly cut."""

import json
from collections.abc import Iterator
from functools import lru_cache
from itertools import islice
from typing import Any

import cbor2
import msgspec

from fleet_tui.model.counters import Raw, TopicCounter
from fleet_tui.robots.ros.cbor import read_cbor
from fleet_tui.text.language import Message, joined, tr, translate
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import ago, size_text
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Row, Table

MOST_LINES = 1000
SHOWN_ITEMS = 12
"""Number of list items that are shown."""
DEEPEST = 30
LONGEST_STRING = 300
LINE = 200
BINARY_LINE = 24
"""Characters of a line of non-JSON text, bytes of one of binary data."""
LONGEST_COPY = 50_000
"""Number of characters that are copied: terminals take about 75,000 bytes."""

_NOTHING = object()


@lru_cache(maxsize=4)
def raw_lines(raw: Raw) -> tuple[str, ...]:
    """Return at most MOST_LINES lines."""
    value = _published(raw)
    lines = _plain(raw) if value is _NOTHING else _value_lines(value, 0)
    shown = tuple(sanitize(line) for line in islice(lines, MOST_LINES + 1))
    return (
        shown
        if len(shown) <= MOST_LINES
        else (*shown[:-1], tr("… first {count} lines only", count=f"{MOST_LINES:,}"))
    )


def copied(raw: Raw) -> tuple[str, str]:
    """Return the text to copy of a message, and its description: complete, whatever the view leaves out."""
    text = "\n".join(sanitize(line) for line in _whole(raw).split("\n"))
    if len(text) <= LONGEST_COPY:
        return text, tr("{count} characters", count=f"{len(text):,}")
    return text[:LONGEST_COPY], tr(
        "the first {limit} of {total} characters", limit=f"{LONGEST_COPY:,}", total=f"{len(text):,}"
    )


def raw_table(topic: TopicCounter, raw: Raw | None, why: str, now: float) -> Table:
    """Return the message of a topic; `why` is the reason it could not be read, empty if it could."""
    title = [(tr("Raw "), StyleRole.TITLE), (sanitize(topic.topic), StyleRole.TEXT)]
    if raw is None:
        return Table(tuple(title), (), tr("no bad message") if why else tr("nothing received yet"))
    kind = Message("CBOR") if raw.is_binary else Message("JSON")
    title.append(
        (
            tr(
                "  {ago}, {size_text} of {kind}",
                ago=translate(ago(raw.at, now)),
                size_text=size_text(raw.size),
                kind=translate(kind),
            ),
            StyleRole.DIM,
        )
    )
    rows = [Row(n, ((line, StyleRole.TEXT),)) for n, line in enumerate(raw_lines(raw))]
    if why:
        title.append((tr("  bad"), StyleRole.ALARM))
        rows.insert(0, Row(tr("why"), ((f"▲ {sanitize(why)}", StyleRole.ALARM),)))
    return Table(tuple(title), rows)


def _published(raw: Raw) -> Any:
    """Return the published value, without the envelope; `_NOTHING` if it can't be read, or is incomplete."""
    if not raw.is_whole:
        return _NOTHING
    try:
        value = read_cbor(raw.payload) if raw.is_binary else msgspec.json.decode(raw.payload)
    except (ValueError, RecursionError, OverflowError):
        return _NOTHING
    return value["msg"] if isinstance(value, dict) and "msg" in value else value


def _plain(raw: Raw) -> Iterator[str]:
    if not raw.is_whole:
        yield tr(
            "… {size}, only the first {kept} kept", size=size_text(raw.size), kept=size_text(len(raw.payload))
        )
    if raw.is_binary:
        for start in range(0, len(raw.payload), BINARY_LINE):
            yield raw.payload[start : start + BINARY_LINE].hex(" ")
        return
    text = raw.payload.decode(errors="replace")
    for start in range(0, len(text), LINE):
        yield text[start : start + LINE]


def _whole(raw: Raw) -> str:
    value = _NOTHING if raw.is_binary else _published(raw)
    if value is _NOTHING:
        return "\n".join(raw_lines(raw))
    return msgspec.json.format(msgspec.json.encode(value), indent=2).decode()


def _value_lines(value: Any, depth: int, before: str = "", after: str = "") -> Iterator[str]:
    pad = "  " * depth
    parts: list[tuple[str, Any]] = []
    if isinstance(value, dict):
        opening, closing, parts = "{", "}", [(f"{_scalar(key)}: ", item) for key, item in value.items()]
    elif isinstance(value, list) and any(isinstance(item, dict | list) for item in value[:SHOWN_ITEMS]):
        opening, closing, parts = "[", "]", [("", item) for item in value[:SHOWN_ITEMS]]
    if not parts or depth >= DEEPEST:
        yield f"{pad}{before}{_inline(value)}{after}"
        return
    yield f"{pad}{before}{opening}"
    left_out = len(value) - len(parts)
    for n, (name, item) in enumerate(parts, 1):
        yield from _value_lines(item, depth + 1, name, "," if n < len(parts) or left_out else "")
    if left_out:
        yield tr(
            "{pad}  … {left_out} more of {total}", pad=pad, left_out=f"{left_out:,}", total=f"{len(value):,}"
        )
    yield f"{pad}{closing}{after}"


def _inline(value: Any) -> str:
    if isinstance(value, list):
        if any(isinstance(item, dict | list) for item in value[:SHOWN_ITEMS]):
            return f"[… {len(value):,}]"
        shown = joined(", ", map(_scalar, value[:SHOWN_ITEMS]))
        left_out = len(value) - SHOWN_ITEMS
        return (
            tr(
                "[{shown}, … {left_out} more of {total}]",
                shown=translate(shown),
                left_out=f"{left_out:,}",
                total=f"{len(value):,}",
            )
            if left_out > 0
            else f"[{shown}]"
        )
    if isinstance(value, dict):
        return f"{{… {len(value):,}}}" if value else "{}"
    return _scalar(value)


def _scalar(value: Any) -> str:
    if isinstance(value, cbor2.CBORTag) and isinstance(value.value, bytes):
        return tr("… {count} bytes, CBOR tag {tag}", count=f"{len(value.value):,}", tag=value.tag)
    if isinstance(value, bytes):
        return tr("… {count} bytes", count=f"{len(value):,}")
    if isinstance(value, str):
        return json.dumps(truncate(value, LONGEST_STRING), ensure_ascii=False)
    if value is None or isinstance(value, bool):
        return json.dumps(value)
    return truncate(repr(value), LONGEST_STRING)
