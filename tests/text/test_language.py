"""Texts in the language of the user: figures and names in them, and what stays as it is."""

from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from fleet_tui.text.language import LONGEST, Catalogue, Message, in_english, joined, read_catalogue, speak, tr
from fleet_tui.text.sanitize import sanitize

MESSAGES = {
    "no link": "keine Verbindung",
    "paused": "pausiert",
    "order": "Auftrag",
    "{count} order": "{count} Auftrag",
    "{count} orders": "{count} Aufträge",
    "{age} ago": "vor {age}",
    "not sent: {problem}": "nicht gesendet: {problem}",
    "{name} is offline": "{name} ist offline",
    "{stopped} of {able} {PAUSED}": "{able}: davon {stopped} {PAUSED}",
}


@pytest.fixture(autouse=True)
def german() -> Iterator[None]:
    speak(Catalogue(MESSAGES))
    yield
    speak(None)


def test_without_a_catalogue_a_text_stays_as_it_is() -> None:
    speak(None)
    assert tr("no link") == "no link"


def test_a_text_and_the_spaces_around_it() -> None:
    assert tr(" no link  ") == " keine Verbindung  "


def test_one_and_many_are_two_messages() -> None:
    assert [tr(text) for text in ("1 order", "2 orders")] == ["1 Auftrag", "2 Aufträge"]


def test_values_go_where_the_language_has_them() -> None:
    assert tr("3 min ago") == "vor 3 min"
    assert (
        tr("{stopped} of {able} {PAUSED}", stopped=2, able=5, PAUSED=Message("paused"))
        == "5: davon 2 pausiert"
    )


def test_a_reason_within_a_text_is_translated_a_name_is_not() -> None:
    assert tr("not sent: no link") == "nicht gesendet: keine Verbindung"
    assert tr("order is offline") == "order ist offline"


def test_lists_lines_and_brackets_are_translated_part_by_part() -> None:
    assert tr("paused; no link") == "pausiert; keine Verbindung"
    assert tr("1 order, paused") == "1 Auftrag, pausiert"
    assert tr("no link\npaused") == "keine Verbindung\npausiert"
    assert tr("no link (paused)") == "keine Verbindung (pausiert)"
    assert tr("robot_1 (robot_2, robot_3)") == "robot_1 (robot_2, robot_3)"


def test_unknown_texts_and_long_ones_stay() -> None:
    assert tr("Packing -> Store") == "Packing -> Store"
    long = "not sent: " + "no link " * LONGEST
    assert tr(long) == long


def test_braces_in_a_value_stay() -> None:
    assert tr("{0} is offline") == "{0} ist offline"


def test_reads_a_po_file() -> None:
    text = (
        '# about\nmsgid ""\nmsgstr "Language: de\\n"\n\n# view\nmsgid "a \\"b\\""\nmsgstr ""\n"c"\n"d\\n"\n'
    )
    assert read_catalogue(text + '\nmsgid "not yet"\nmsgstr ""\n') == {'a "b"': "cd\n"}


def test_refuses_what_is_no_po_file() -> None:
    with pytest.raises(ValueError, match="no line of a catalogue: Auftrag"):
        read_catalogue('msgid "order"\nAuftrag\n')


def test_texts_put_together_are_translated_in_their_parts() -> None:
    assert tr(joined("; ", ["paused", Message("{age} ago", age="4 s")])) == "pausiert; vor 4 s"
    assert tr("paused " + Message("{age} ago", age="4 s")) == "pausiert vor 4 s"
    assert tr(Message("{age} ago", age="4 s") + " paused") == "vor 4 s pausiert"


def test_it_is_written_in_english_and_what_is_no_text_not_at_all() -> None:
    record = {"detail": Message("{age} ago", age="4 s")}
    assert msgspec.json.encode(record, enc_hook=in_english) == b'{"detail":"4 s ago"}'
    with pytest.raises(NotImplementedError):
        msgspec.json.encode(object(), enc_hook=in_english)


def test_a_path_within_a_text_is_sanitized_too() -> None:
    assert "\x1b" not in sanitize(Message("not sent: {problem}", problem=Path("a\x1b[2J")))
