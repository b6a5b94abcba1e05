"""The language of the screen: its texts in the words of the user, English without a catalogue.

A text is made as a `Message`, whose string is English, as the audit log, JSON and the log file have it; it is
translated where it is shown.
"""

from collections.abc import Callable, Iterable, Mapping
from gettext import NullTranslations
from typing import Any, Self

_PLAIN = str, int, float


class Message(str):
    """A text of the console: as a string its English. It is translated by its `id`, which is the English with
    places for the values, `no link for {age}`. Values that are messages are translated, too; all others stay
    as they are: names, figures, and what robots and people say."""

    __slots__ = ("id", "many", "values")

    id: str
    many: str
    values: Mapping[str, object]

    def __new__(cls, id: str, /, **values: object) -> Self:
        return id if isinstance(id, cls) else cls._made(id, "", values, id)

    @classmethod
    def _made(cls, id: str, many: str, values: Mapping[str, object], english: str) -> Self:
        for value in values.values():
            if not isinstance(value, _PLAIN):
                # A path or an exception is text from outside as well: `sanitize` must see it.
                values = {
                    name: value if isinstance(value, _PLAIN) else text_of(value)
                    for name, value in values.items()
                }
                break
        made = super().__new__(cls, english.format_map(values) if values else english)
        made.id, made.many, made.values = id, many, values
        return made

    def changed(self, change: Callable[[str], str]) -> Self:
        """Return the message with its own text, which may come from a file, and its values changed."""
        values = {
            name: change(value) if isinstance(value, str) else value for name, value in self.values.items()
        }
        id, many = change(self.id), change(self.many)
        return self._made(id, many, values, many if many and values["count"] != 1 else id)

    def __add__(self, other: str) -> "Message":
        return Message("{text}{rest}", text=self, rest=other)

    def __radd__(self, other: str) -> "Message":
        return Message("{text}{rest}", text=other, rest=self)


EMPTY = Message("")


def counted(one: str, many: str, count: int, /, **values: object) -> Message:
    """Return the text for a count, which is its value `count`, by the plural rules of each language."""
    return Message._made(one, many, {"count": count, **values}, one if count == 1 else many)


_VERBATIM = "{text}"


def verbatim(text: object) -> Message:
    """Return what a robot, a person or a file says: it is never looked up."""
    said = text if isinstance(text, str) else text_of(text)
    made = str.__new__(Message, said)
    made.id, made.many, made.values = _VERBATIM, "", {"text": said}
    return made


def is_verbatim(message: Message) -> bool:
    return message.id == _VERBATIM


def text_of(value: object) -> str:
    """Return a value as text, an exception as the message that it was raised with."""
    if isinstance(value, BaseException) and value.args and isinstance(value.args[0], Message):
        return value.args[0]
    return str(value)


def message_of(error: BaseException) -> Message:
    """Return the text of an exception: verbatim, unless it was raised with a message."""
    text = text_of(error)
    return text if isinstance(text, Message) else verbatim(text)


N_ = str
"""Marks a text that is put into a message elsewhere, for its extraction."""


def joined(separator: str, texts: Iterable[str]) -> Message:
    """Return texts as one."""
    texts = list(texts)
    if not any(isinstance(text, Message) for text in texts):
        return verbatim(separator.join(texts))
    parts = {f"part{n}": text for n, text in enumerate(texts)}
    return Message(separator.join(f"{{{name}}}" for name in parts), **parts)


def with_values(message: Message) -> dict[str, object]:
    """Return a message as JSON types that keep what `message_with_values` needs to translate it."""
    values = {
        name: with_values(value) if isinstance(value, Message) else value
        for name, value in message.values.items()
    }
    return {"id": message.id, "many": message.many, "values": values}


def message_with_values(kept: dict[str, Any]) -> Message:
    """Return a message that was kept with its values. Raises KeyError, TypeError and ValueError."""
    values = {
        name: message_with_values(value) if isinstance(value, dict) else value
        for name, value in kept["values"].items()
    }
    if kept["many"]:
        return counted(kept["id"], kept["many"], int(str(values.pop("count"))), **values)
    return Message(kept["id"], **values)


def as_written(kind: type, value: object) -> Message:
    """Return a message of a file verbatim, since robots say words of the console, too. A hook of msgspec."""
    if kind is Message and isinstance(value, str):
        return verbatim(value)
    raise NotImplementedError(kind)


def in_english(value: object) -> str:
    """Return a message as msgspec has to write it: its hook for what it does not know."""
    if isinstance(value, Message):
        return str(value)
    raise NotImplementedError(type(value))


_translations = NullTranslations()


def speak(translations: NullTranslations) -> None:
    """Show all texts of this process in a language."""
    global _translations
    _translations = translations


def translate(message: Message) -> str:
    """Return a text of the console in the language of its user."""
    if type(_translations) is NullTranslations:
        return str(message)
    if not isinstance(message, Message) or not message.id:
        return message  # what `replace` put there, unchecked; and gettext has its header at the empty text
    if message.many:
        count = message.values["count"]
        text = _translations.ngettext(message.id, message.many, count if isinstance(count, int) else 2)
    else:
        text = _translations.gettext(message.id)
    if not message.values:
        return text
    return text.format_map(
        {
            name: translate(value) if isinstance(value, Message) else value
            for name, value in message.values.items()
        }
    )


def tr(id: str, /, **values: object) -> str:
    """Return the text of this id, which is written here, in the language of its user."""
    if type(_translations) is NullTranslations:
        return id.format_map(values) if values else id
    return translate(Message(id, **values))
