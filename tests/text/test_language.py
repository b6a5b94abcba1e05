"""Texts in the language of the user: figures and names in them, and what stays as it is."""

from collections.abc import Iterator
from gettext import NullTranslations
from pathlib import Path

import msgspec
import pytest

from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import (
    EMPTY,
    Message,
    as_written,
    counted,
    in_english,
    joined,
    message_of,
    speak,
    tr,
    translate,
    verbatim,
)
from fleet_tui.text.sanitize import sanitize

TEXTS = {
    "no link": "keine Verbindung",
    "paused": "pausiert",
    "{count} order": "{count} Auftrag",
    "{count} orders": "{count} Aufträge",
    "{age} ago": "vor {age}",
    "not sent: {problem}": "nicht gesendet: {problem}",
    "{name} is offline": "{name} ist offline",
    "{stopped} of {able} {paused}": "{able}: davon {stopped} {paused}",
}


class German(NullTranslations):
    def gettext(self, message: str) -> str:
        return TEXTS.get(message, message)

    def ngettext(self, msgid1: str, msgid2: str, n: int) -> str:
        return self.gettext(msgid1 if n == 1 else msgid2)


@pytest.fixture(autouse=True)
def german() -> Iterator[None]:
    speak(German())
    yield
    speak(NullTranslations())


def test_without_a_catalogue_a_text_stays_as_it_is() -> None:
    speak(NullTranslations())
    assert tr("no link") == "no link"
    assert translate(counted("{count} order", "{count} orders", 2)) == "2 orders"


def test_one_and_many_are_forms_of_one_message() -> None:
    both = [counted("{count} order", "{count} orders", count) for count in (1, 2)]
    assert both == ["1 order", "2 orders"]
    assert list(map(translate, both)) == ["1 Auftrag", "2 Aufträge"]


def test_values_go_where_the_language_has_them() -> None:
    assert tr("{age} ago", age="3 min") == "vor 3 min"
    text = Message("{stopped} of {able} {paused}", stopped=2, able=5, paused=Message("paused"))
    assert translate(text) == "5: davon 2 pausiert"
    assert text == "2 of 5 paused"


def test_a_reason_within_a_text_is_translated_a_name_is_not() -> None:
    assert tr("not sent: {problem}", problem=Message("no link")) == "nicht gesendet: keine Verbindung"
    assert tr("{name} is offline", name="paused") == "paused ist offline"


def test_what_others_say_is_never_looked_up() -> None:
    assert translate(verbatim("no link")) == "no link"
    assert translate(verbatim("{age} of {0} %s")) == "{age} of {0} %s"


def test_an_empty_text_is_empty_in_every_language() -> None:
    assert translate(EMPTY) == ""
    assert not EMPTY


def test_an_exception_within_a_text_is_the_message_that_it_was_raised_with() -> None:
    problem = CommandError(Message("no link"))
    assert message_of(problem) == "no link"
    assert tr("not sent: {problem}", problem=problem) == "nicht gesendet: keine Verbindung"
    assert translate(message_of(ValueError("paused"))) == "paused"


def test_texts_put_together_are_translated_in_their_parts() -> None:
    assert (
        translate(joined("; ", [Message("paused"), Message("{age} ago", age="4 s")])) == "pausiert; vor 4 s"
    )
    assert translate("paused " + Message("{age} ago", age="4 s")) == "paused vor 4 s"
    assert translate(Message("{age} ago", age="4 s") + Message("paused")) == "vor 4 spausiert"


def test_it_is_written_in_english_and_what_is_no_text_not_at_all() -> None:
    record = {"detail": Message("{age} ago", age="4 s")}
    assert msgspec.json.encode(record, enc_hook=in_english) == b'{"detail":"4 s ago"}'
    with pytest.raises(NotImplementedError):
        msgspec.json.encode(object(), enc_hook=in_english)


def test_a_text_of_a_file_is_shown_as_it_was_written() -> None:
    """A robot's word in a recording may be one of the console's."""
    said = msgspec.json.decode(b'["no link"]', type=list[Message], dec_hook=as_written)
    assert translate(said[0]) == said[0] == "no link"
    with pytest.raises(NotImplementedError):
        as_written(object, {})


def test_a_path_within_a_text_is_sanitized_too() -> None:
    assert "\x1b" not in sanitize(Message("not sent: {problem}", problem=Path("a\x1b[2J")))


def test_a_sanitized_message_has_its_plural_still() -> None:
    text = sanitize(counted("{count} order", "{count} orders", 2, name="\x1b"))
    assert translate(text) == "2 Aufträge"
