"""The language of the screen: its texts in the words of the user, English without a catalogue.

Everything is made in English, as the audit log, JSON and the log file have it, and translated where it is
shown. A message of a catalogue may have places for what differs, `no link for {age}`, so that texts with
figures and names, which come ready from the state, find their translation, too.
"""

import json
import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Self

from msgspec import Struct

_TEXTS = (
    "after ago asked behind blind calls cells claims command_reason counted counts_text detail"
    " did_you_mean difference_text does doing doubt halved held how impact its jitter key kind lack"
    " last_fault lift loaded looks lost_why mission most mutual near newest note noun noun_of others owner"
    " pending present problem question reason refusal remedy removeprefix rest ruled_out shown silence silent"
    " since spread stage state_text steps tmux to_start told too text trying unit value verb way_text"
    " way_text2 ways what where why CONDITIONS PAUSED READ_AS_0 STARTED_OVER"
    " cause e_stop_text mode_text withheld zone"
)
TEXTS = frozenset(_TEXTS.split(" "))
"""Places whose values are texts of the console, and translated, too; those of all others stay as they are:
names, paths, figures, and what robots say."""
_NUMBER = r"[-\d.,]+"
_DURATION = r"[\d.]+ \w+|never"
_COUNTS = ("alarms", "count", "edges", "faults", "fresh", "marks", "metres", "orders", "placed", "vertices")
FIGURES = {
    **dict.fromkeys((*_COUNTS, "waiting"), _NUMBER),
    **dict.fromkeys(("age", "duration", "lasted"), _DURATION),
    **dict.fromkeys(("path", "id", "order", "order_id"), r"\S+?"),
    "name": r"\S+",
    "mission": r"order .*|.* -> .*",
    "route": r"[^()]*",
    "way": r"[^()]*",
    "looks": r"(?: looks at [^,]*)?",
    "to_start": r"(?:\d+ m to the start, then )?",
    "lift": r"(?:, by lift)?",
    "claims": r"(?:, claims .*)?",
    "label": r".*?",
}
"""Expressions for values of which more is known than that they are texts."""
PER_CENT = r"[-\d.]+"
"""The expression for a value before a per cent sign."""
FEW = 5
"""Letters of its own below which a message fits nearly everything, `{name} to {place}`: unless all its values
are figures, a text is never taken for it by its looks."""
REMEMBERED = 8192
"""Texts with their translations: the screen asks for the same ones ten times a second."""
LONGEST = 300
"""Characters of a line above which it is no text of the console: a robot may say anything."""
_PLACE = re.compile(r"\{(\w+)\}")
_LISTS = {"; ": re.compile("; "), ", ": re.compile(r", (?![^(]*\))")}
_FIELD = re.compile(r'(msgid|msgstr)? *(".*")')


class Message(str):
    """A text of the console: as a string its English. It is translated by its `id`, which is the English with
    places for the values, `no link for {age}`; a value that is no message stays as it is."""

    __slots__ = ("id", "values")

    id: str
    values: Mapping[str, object]

    def __new__(cls, id: str, /, **values: object) -> Self:
        if isinstance(id, cls):
            return id
        # A path or an exception is text from outside as well: `sanitize` must see it.
        values = {
            name: value if isinstance(value, str | int | float) else str(value)
            for name, value in values.items()
        }
        made = super().__new__(cls, id.format_map(values) if values else id)
        made.id = id
        made.values = values
        return made

    def __add__(self, other: str) -> "Message":
        return Message("{text}{rest}", text=self, rest=Message(other))

    def __radd__(self, other: str) -> "Message":
        return Message(other) + self


def joined(separator: str, texts: Iterable[str]) -> Message:
    """Return texts of the console as one."""
    parts = {f"part{n}": Message(text) for n, text in enumerate(texts)}
    return Message(separator.join(f"{{{name}}}" for name in parts), **parts)


def in_english(value: object) -> str:
    """Return a message as msgspec has to write it: its hook for what it does not know."""
    if isinstance(value, Message):
        return str(value)
    raise NotImplementedError(type(value))


class MessagePattern(Struct, frozen=True):
    """A message with places: the longest text between them, all of it as an expression, its translation."""

    part: str
    expression: re.Pattern[str]
    translation: str


class Catalogue:
    """Translations of messages."""

    def __init__(self, messages: Mapping[str, str]) -> None:
        self._messages = messages
        self._plain = {msgid: text for msgid, text in messages.items() if not _PLACE.search(msgid)}
        placed = sorted(filter(is_guessed, messages.keys() - self._plain.keys()), key=_freedom)
        self._placed = [_pattern(msgid, messages[msgid]) for msgid in placed]
        self._remembered = lru_cache(REMEMBERED)(self._translated)

    def translated(self, text: str) -> str:
        """Return a text in this language, as it is if the catalogue does not have it."""
        if not isinstance(text, Message):
            return self._remembered(text)
        msgid = text.id.strip()
        if not text.values:
            return self._remembered(text.id)
        translation = text.id.replace(msgid, self._messages.get(msgid, msgid), 1)
        return translation.format_map(
            {
                name: self.translated(value) if isinstance(value, Message) else value
                for name, value in text.values.items()
            }
        )

    def _translated(self, text: str) -> str:
        """Return what is not known as a message, line by line."""
        if "\n" in text:
            return "\n".join(map(self.translated, text.split("\n")))
        if len(text) > LONGEST:
            return text
        told = text.strip()
        found = self._plain.get(told) or self._filled(told) or self._in_parts(told)
        return text.replace(told, found, 1) if found else text

    def _in_parts(self, told: str) -> str:
        """Return a list translated part by part, a text after a name, one with a detail in brackets."""
        for mark, between in _LISTS.items():
            if mark in told and len(parts := between.split(told)) > 1:
                return mark.join(map(self.translated, parts))
        name, colon, rest = told.partition(": ")
        if colon and " " not in name and not name.isupper():
            return f"{name}: {self.translated(rest)}"
        head, opening, detail = told.removesuffix(")").partition(" (")
        is_told = opening and told.endswith(")")
        return f"{self.translated(head)} ({self.translated(detail)})" if is_told else ""

    def _filled(self, told: str) -> str:
        for message in self._placed:
            if message.part in told and (match := message.expression.fullmatch(told)):
                values = match.groupdict()
                texts = {name: self.translated(values[name]) for name in TEXTS & values.keys()}
                return message.translation.format_map(values | texts)
        return ""


def _freedom(msgid: str) -> tuple[int, int, int]:
    """Return what sorts messages: those with the most letters of their own are tried first, then those whose
    values are known best."""
    names = _PLACE.findall(msgid)
    letters = "".join(_PLACE.sub("", msgid).split())
    return -len(letters), len(names), -sum(name in FIGURES or name in TEXTS for name in names)


def is_guessed(msgid: str) -> bool:
    """Tell whether a text that is no message may be taken for this one, by its looks."""
    is_of_figures = all(FIGURES.get(name) in (_NUMBER, _DURATION) for name in _PLACE.findall(msgid))
    return is_of_figures or sum(map(str.isalpha, _PLACE.sub("", msgid))) >= FEW


def _pattern(msgid: str, translation: str) -> MessagePattern:
    parts = _PLACE.split(msgid)  # texts and names in turn
    made = [re.escape(part) for part in parts]
    made[1::2] = [
        f"(?P<{name}>{PER_CENT if after.startswith(' %') else _value(name)})"
        for name, after in zip(parts[1::2], parts[2::2], strict=True)
    ]
    return MessagePattern(max(parts[::2], key=len), re.compile("".join(made)), translation)


def _value(name: str) -> str:
    if name in FIGURES:
        return FIGURES[name]
    return r"[^:,]*?" if name in ("name", "robot") else ".*?"


def read_catalogue(text: str) -> dict[str, str]:
    """Return the messages of a .po file with their translations, those without one left out. Raises
    ValueError for a line that is none of such a file."""
    found: dict[str, str] = {}
    for entry in re.split(r"\n(?=msgid )", text):
        fields = {"msgid": "", "msgstr": ""}
        name = ""
        for line in filter(lambda line: line and not line.startswith("#"), entry.splitlines()):
            field = _FIELD.fullmatch(line.strip())
            if field is None or not (name := field[1] or name):
                raise ValueError(f"no line of a catalogue: {line}")
            fields[name] += json.loads(field[2])
        if fields["msgid"] and fields["msgstr"]:
            found[fields["msgid"]] = fields["msgstr"]
    return found


_translate: Callable[[str], str] = str


def speak(catalogue: Catalogue | None) -> None:
    """Show all texts of this process in the language of a catalogue, in English without one."""
    global _translate
    _translate = catalogue.translated if catalogue is not None else str


def tr(text: str, /, **values: object) -> str:
    """Return a text of the console in the language of its user; with values, the message of this id."""
    return _translate(Message(text, **values) if values else text)
