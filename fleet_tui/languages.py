"""The languages of the screen: one catalogue each, `locales/LANGUAGE.po`."""

from importlib.resources import files

from fleet_tui.text.language import Catalogue, read_catalogue, speak

ENGLISH = "en"
"""The language of the texts in the code: it has no catalogue."""


def use_language(language: str) -> None:
    """Show all texts of this process in a language."""
    if language == ENGLISH:
        speak(None)
        return
    text = files("fleet_tui").joinpath("locales", f"{language}.po").read_text(encoding="utf-8")
    speak(Catalogue(read_catalogue(text)))
