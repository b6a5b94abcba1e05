"""The catalogues: complete, with the same places, of the languages that the configuration accepts."""

import re
import typing
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.schema import Ui
from fleet_tui.text.language import Message, counted, joined, tr, translate, verbatim
from fleet_tui.ui.languages import ENGLISH, use_language
from tests.support.catalogues import LANGUAGES, LOCALES, called, catalogue, extracted, translations

pytestmark = pytest.mark.one_fork


@pytest.fixture(autouse=True)
def english_again() -> Iterator[None]:
    yield
    use_language(ENGLISH)


def places(message: str) -> list[str]:
    """The names of what is filled in."""
    return re.findall(r"\{(\w+)\}", message)


def test_the_configuration_accepts_english_and_each_catalogue() -> None:
    assert sorted(typing.get_args(typing.get_type_hints(Ui)["language"])) == sorted([ENGLISH, *LANGUAGES])


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_message_of_the_code_has_a_translation_and_no_other(language: str) -> None:
    known = {message.id for message in catalogue(language) if message.id}
    assert [message for message in extracted() if message not in known] == []
    assert [message for message in known if message not in extracted()] == []
    assert [one for one, text in translations(language).items() if one and not text] == []


def test_babel_sees_each_text_of_the_code() -> None:
    """In Python 3.11 it sees none within an f-string."""
    seen = {form for message in extracted() for form in ([message] if isinstance(message, str) else message)}
    assert [one for one in called() if one[1] not in seen] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_has_the_places_of_its_message(language: str) -> None:
    wrong = [
        (one, text)
        for one, text in translations(language).items()
        if sorted(places(one)) != sorted(places(text))
    ]
    assert wrong == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_compiled_is_the_catalogue(language: str) -> None:
    compiled = LOCALES / language / "LC_MESSAGES" / "fleet_tui.mo"
    assert compiled.is_file(), "compile it: make messages"
    use_language(language)
    texts = {one: tr(one) for one in translations(language) if not places(one)}
    assert texts == {one: text for one, text in translations(language).items() if one in texts}


def test_a_language_is_used_until_another_one_is() -> None:
    use_language("pt")
    assert tr("no link") == "sem ligação"
    use_language("de")
    assert tr("no link") == "keine Verbindung"
    use_language(ENGLISH)
    assert tr("no link") == "no link"


HOSTILE = (
    "Failed to make progress",
    "door to hall locked",
    "no link",
    "{name} on {0}",
    "%s %",
    "\u202eabc",
    "x" * 10_000,
)


@pytest.mark.parametrize("language", [ENGLISH, *LANGUAGES])
def test_values_are_in_every_text_as_they_are(language: str) -> None:
    use_language(language)
    texts = translations(language) if language != ENGLISH else {one: one for one in translations("de")}
    forms = [message.id for message in catalogue("de") if message.id]

    def assert_shown(said: str) -> None:
        for form in forms:
            one, many = (form, "") if isinstance(form, str) else form
            for value in ("{said}", "«{name} {said}»"):
                names = [name for name in places(one) if not many or name != "count"]
                values = {name: value.format(name=name, said=said) for name in names}
                if many:
                    message, english = counted(one, many, 7, **values), many
                else:
                    message, english = Message(one, **values), one
                assert message == _filled(english, {"count": "7", **values})
                assert translate(message) == _filled(texts[english], {"count": "7", **values})

    for said in HOSTILE:
        assert_shown(said)
    given(st.text(max_size=40))(assert_shown)()


def _filled(text: str, values: dict[str, str]) -> str:
    return re.sub(r"\{(\w+)\}", lambda place: values[place[1]], text)


def test_a_message_within_a_message_is_translated_too() -> None:
    use_language("de")
    not_sent = "not sent: {problem}"
    assert tr(not_sent, problem=Message("no link")) == "nicht gesendet: keine Verbindung"
    assert tr(not_sent, problem="no link") == "nicht gesendet: no link"
    both = joined(", ", [Message("no link"), Message("{duration} ago", duration="4 s")])
    assert translate(both) == "keine Verbindung, vor 4 s"


def test_the_words_of_a_robot_stay_as_they_are() -> None:
    use_language("de")
    assert translate(verbatim("Failed to make progress")) == "Failed to make progress"
    refused = Message("not sent: {problem}", problem="door to hall locked")
    assert translate(refused) == "nicht gesendet: door to hall locked"


@pytest.mark.parametrize(
    ("language", "none", "one"), [("de", "0 Aufträge", "1 Auftrag"), ("pt", "0 ordens", "1 ordem")]
)
def test_none_is_many(language: str, none: str, one: str) -> None:
    use_language(language)
    texts = [translate(counted("{count} order", "{count} orders", count)) for count in (0, 1, 2, 1_000_000)]
    assert texts[:2] == [none, one]
    assert {text.split()[1] for text in texts[2:]} == {none.split()[1]}
