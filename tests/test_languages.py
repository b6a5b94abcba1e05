"""The catalogues: complete, with the same places, of the languages that the configuration accepts."""

import re
import typing
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.schema import Ui
from fleet_tui.languages import ENGLISH, use_language
from fleet_tui.text.language import FIGURES, Catalogue, Message, is_guessed, read_catalogue, tr
from tests.support.screen_texts import ROOT, texts

LANGUAGES = sorted(path.stem for path in (ROOT / "locales").glob("*.po"))
COMPOSED = "\n# composed\n"
"""The part of a file with messages that are put together from parts, which the collection does not see."""


@pytest.fixture(autouse=True)
def english_again() -> Iterator[None]:
    yield
    use_language(ENGLISH)


def places(message: str) -> list[str]:
    """The names of what is filled in."""
    return re.findall(r"\{(\w+)\}", message)


def file_of(language: str) -> str:
    return (ROOT / "locales" / f"{language}.po").read_text(encoding="utf-8")


def test_the_configuration_accepts_english_and_each_file() -> None:
    assert sorted(typing.get_args(typing.get_type_hints(Ui)["language"])) == sorted([ENGLISH, *LANGUAGES])


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_of_the_screen_has_a_translation(language: str) -> None:
    assert sorted(texts() - read_catalogue(file_of(language)).keys()) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_has_the_places_of_its_message(language: str) -> None:
    messages = read_catalogue(file_of(language))
    wrong = [(one, text) for one, text in messages.items() if sorted(places(one)) != sorted(places(text))]
    assert wrong == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_message_is_there_twice_or_without_a_use(language: str) -> None:
    text = file_of(language)
    assert text.count("\nmsgid ") - 1 == len(read_catalogue(text))
    collected, composed = text.split(COMPOSED)
    assert sorted(set(read_catalogue(collected)) - texts()) == []
    assert read_catalogue(composed).keys() == read_catalogue(file_of("de").split(COMPOSED)[1]).keys()


def test_a_language_is_used_until_another_one_is() -> None:
    use_language("pt")
    assert tr("no link") == "sem ligação"
    use_language("de")
    assert tr("no link") == "keine Verbindung"
    use_language(ENGLISH)
    assert tr("no link") == "no link"


@pytest.mark.parametrize("language", LANGUAGES)
def test_messages_of_one_shape_have_translations_of_one_shape(language: str) -> None:
    """A text does not tell which of them it is: `{name} on link {link}`, `{edge} on link {floor}`."""
    found: dict[str, set[str]] = {}
    for one, text in read_catalogue(file_of(language)).items():
        if not is_guessed(one):
            continue
        shape = re.sub(r"\{(\w+)\}", lambda place: FIGURES.get(place[1], "*"), one)
        for number, place in enumerate(places(one)):
            text = text.replace(f"{{{place}}}", f"<{number}>")
        found.setdefault(shape, set()).add(text)
    assert [many for many in found.values() if len(many) > 1] == []


def test_what_people_write_and_call_things_stays_as_it_is() -> None:
    use_language("de")
    note = "robot_2: lost, idle"
    assert tr(f"noted for the next shift: {note}") == f"notiert für die nächste Schicht: {note}"
    assert "18 - no link sperren" in tr("Close 18 - no link: cuts the way of no order")


HOSTILE = (
    "Failed to make progress",
    "door to hall locked",
    "no link",
    "{name} on {0}",
    "%s %",
    "\u202eabc",
    "x" * 10_000,
)


@pytest.mark.parametrize("language", LANGUAGES)
def test_values_are_in_every_text_as_they_are(language: str) -> None:
    messages = read_catalogue(file_of(language))
    catalogue = Catalogue(messages)

    def assert_shown(said: str) -> None:
        for msgid in filter(places, messages):
            for value in ("{said}", "«{name} {said}»"):
                values = {name: value.format(name=name, said=said) for name in places(msgid)}
                message = Message(msgid, **values)
                assert message == _filled(msgid, values)
                assert catalogue.translated(message) == _filled(messages[msgid], values)

    for said in HOSTILE:
        assert_shown(said)
    given(st.text(max_size=40))(assert_shown)()


def _filled(text: str, values: dict[str, str]) -> str:
    return re.sub(r"\{(\w+)\}", lambda place: values[place[1]], text)


def test_a_message_within_a_message_is_translated_too() -> None:
    use_language("de")
    assert (
        tr("{duration} late: {word}", duration="4 s", word=Message("no link"))
        == "4 s zu spät: keine Verbindung"
    )
    assert tr("{duration} late: {word}", duration="4 s", word="no link") == "4 s zu spät: no link"


def test_the_words_of_a_robot_stay_as_they_are() -> None:
    use_language("de")
    assert tr("Failed to make progress") == "Failed to make progress"
    refused = Message("refused: {what}", what=Message("door to hall locked"))
    assert tr(refused) == "abgelehnt: door to hall locked"
    assert tr(Message("no link") + Message(", {age} ago", age="4 s")) == "keine Verbindung, vor 4 s"


def test_a_figure_in_per_cent_is_no_text() -> None:
    use_language("de")
    assert tr("battery alarm, battery 0 %") == "Alarm Akku, Akku 0 %"
