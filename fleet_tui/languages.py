"""The languages of the screen: one catalogue each, `locales/LANGUAGE.po`."""

from pathlib import Path

from fleet_tui.text.language import Catalogue, read_catalogue, speak

ENGLISH = "en"
"""The language of the texts in the code: it has no catalogue."""


def use_language(language: str) -> None:
    """Show all texts of this process in a language."""
    if language == ENGLISH:
        speak(None)
        return
    file = Path(__file__).with_name("locales") / f"{language}.po"
    speak(Catalogue(read_catalogue(file.read_text(encoding="utf-8"))))
