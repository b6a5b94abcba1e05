"""YAML as graph files need it: no tags, bounded aliases, names as text.

Reads the parser's own events, so that neither a name (`yes`, `007`) nor a tag becomes another object.
"""

import math
import re
from collections.abc import Iterable
from typing import Any

import yaml

from fleet_tui.maps.formats.json_text import quoted
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

DEEPEST = 40
MOST_NODES = 3_000_000
"""Maximum values of a file; an alias counts as all values that it stands for."""

_PARSER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_INTEGER = re.compile(r"[-+]?(?:0|[1-9][0-9]{0,30})")
_FLOAT = re.compile(r"[-+]?(?:(?:[0-9]+\.[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?|[0-9]+[eE][-+]?[0-9]+)")
_PLAIN_KEY = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")
_WORDS = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False}
_NULLS = frozenset({"", "~", "null", "Null", "NULL"})
_SPECIAL = {".nan": math.nan, ".inf": math.inf, "+.inf": math.inf, "-.inf": -math.inf}
_RESERVED = _NULLS | _WORDS.keys() | {"yes", "no", "on", "off"}


class PlainText(str):
    """A value written without quotes: a name as it is, and otherwise what it looks like."""

    __slots__ = ()


def settled(value: Any) -> Any:
    """Return a value with numbers, booleans and nulls recognised, in lists and mappings too."""
    if isinstance(value, PlainText):
        return _scalar(value)
    if isinstance(value, list):
        return [settled(one) for one in value]
    if isinstance(value, dict):
        return {key: settled(one) for key, one in value.items()}
    return value


def _scalar(text: str) -> Any:
    if text in _WORDS:
        return _WORDS[text]
    if _INTEGER.fullmatch(text):
        return int(text)
    if _FLOAT.fullmatch(text):
        return float(text)
    if text in _NULLS:
        return None
    return _SPECIAL.get(text.lower(), str(text))


class _Builder:
    """Builds values from events. Each open list or mapping is on the stack with its key, anchor and size."""

    def __init__(self) -> None:
        self._stack: list[tuple[Any, Any, int]] = []
        self._key: Any = None
        self._anchors: dict[str, tuple[Any, int]] = {}
        self._open: set[str] = set()
        self.count = 0
        self.result: Any = None

    def add(self, value: Any, line: int) -> None:
        """Add a value to the innermost list or mapping; as a mapping's key where one is expected."""
        self.count += 1
        if self.count > MOST_NODES:
            raise GraphError(
                Message("over {most_nodes} values: split the file", most_nodes=f"{MOST_NODES:,}")
            )
        if not self._stack:
            self.result = value
            return
        holder = self._stack[-1][0]
        if type(holder) is list:
            holder.append(value)
        elif self._key is None:
            self._key = _key(value, line)
            if self._key in holder:
                raise GraphError(
                    Message(
                        "line {line}: key {key} twice: remove one",
                        line=line,
                        key=f"{truncate(self._key, 40)!r}",
                    )
                )
        else:
            holder[self._key] = value
            self._key = None

    def alias(self, anchor: str, line: int) -> None:
        """Add the value of an anchor."""
        if anchor in self._open:
            raise GraphError(
                Message(
                    "line {line}: alias *{alias} within its own value: write it out",
                    line=line,
                    alias=truncate(anchor, 40),
                )
            )
        if anchor not in self._anchors:
            raise GraphError(
                Message("line {line}: unknown alias *{alias}", line=line, alias=truncate(anchor, 40))
            )
        value, size = self._anchors[anchor]
        self.count += size
        self.add(value, line)

    def anchor(self, name: str | None, value: Any, size: int = 1) -> None:
        if name is not None:
            self._anchors[name] = (value, size)

    def enter(self, value: Any, anchor: str | None, line: int) -> None:
        """Begin a list or a mapping."""
        if len(self._stack) >= DEEPEST:
            raise GraphError(
                Message("line {line}: nested more than {deepest} deep", line=line, deepest=DEEPEST)
            )
        if self._key is None and self._stack and type(self._stack[-1][0]) is dict:
            raise GraphError(Message("line {line}: a key must be text", line=line))
        self.add(value, line)
        self._stack.append((value, anchor, self.count))
        if anchor is not None:
            self._open.add(anchor)

    def leave(self) -> None:
        value, anchor, before = self._stack.pop()
        if anchor is not None:
            self._open.discard(anchor)
        self.anchor(anchor, value, self.count - before + 1)


def _key(value: Any, line: int) -> str:
    if not isinstance(value, str):
        raise GraphError(Message("line {line}: a key must be text", line=line))
    return str(value)


def parse_yaml(text: str) -> Any:
    """Return the one document of a file. Texts without quotes are PlainText. Raises GraphError."""
    builder = _Builder()
    try:
        _build(builder, text)
    except yaml.MarkedYAMLError as problem:
        mark = problem.problem_mark or problem.context_mark
        where = f" in line {mark.line + 1}" if mark else ""
        raise GraphError(
            Message("not YAML: {problem}{where}", problem=problem.problem or problem.context, where=where)
        ) from None
    except yaml.YAMLError as problem:
        raise GraphError(
            Message("not YAML: {problem}", problem=truncate(" ".join(str(problem).split()), 200))
        ) from None
    except (RecursionError, ValueError) as problem:
        raise GraphError(Message("not YAML: {problem}", problem=truncate(str(problem), 200))) from None
    return builder.result


def _build(builder: _Builder, text: str) -> None:
    documents = 0
    events: Iterable[Any] = yaml.parse(text, Loader=_PARSER)
    for event in events:
        kind = type(event)
        if kind is yaml.ScalarEvent:
            _check_tag(event)
            value = event.value if event.style else PlainText(event.value)
            builder.anchor(event.anchor, value)
            builder.add(value, event.start_mark.line + 1)
        elif kind is yaml.SequenceStartEvent:
            _check_tag(event)
            builder.enter([], event.anchor, event.start_mark.line + 1)
        elif kind is yaml.MappingStartEvent:
            _check_tag(event)
            builder.enter({}, event.anchor, event.start_mark.line + 1)
        elif kind is yaml.SequenceEndEvent or kind is yaml.MappingEndEvent:
            builder.leave()
        elif kind is yaml.AliasEvent:
            builder.alias(event.anchor, event.start_mark.line + 1)
        elif kind is yaml.DocumentStartEvent:
            documents += 1
            if documents > 1:
                raise GraphError(
                    Message("line {line}: a second document: split the file", line=event.start_mark.line + 1)
                )


def _check_tag(event: Any) -> None:
    if event.tag is not None:
        line = event.start_mark.line + 1
        raise GraphError(
            Message(
                "line {line}: tag {tag} not supported: remove it",
                line=line,
                tag=f"{truncate(event.tag, 40)!r}",
            )
        )


def flow(value: Any) -> str:
    """Return a value in one line; texts always in quotes, so that no reader takes a name for a number."""
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key_text(key)}: {flow(one)}' for key, one in value.items())}}}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(flow, value))}]"
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return float_text(value)
    return str(value) if isinstance(value, int) else quoted(str(value))


def key_text(key: object) -> str:
    """Return a mapping's key, in quotes unless it is a simple word."""
    text = str(key)
    is_plain = _PLAIN_KEY.fullmatch(text) and text.lower() not in _RESERVED
    return text if is_plain else quoted(text)


def float_text(value: float) -> str:
    """Return a float with a point: without one YAML 1.1 reads an exponent as text."""
    if not math.isfinite(value):
        return ".nan" if math.isnan(value) else (".inf" if value > 0 else "-.inf")
    text = repr(value)
    return text.replace("e", ".0e") if "e" in text and "." not in text else text
