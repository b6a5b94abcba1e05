"""The languages of the screen: one catalogue each, `locales/LANGUAGE/LC_MESSAGES/fleet_tui.po`, compiled when
the program is built."""

from gettext import NullTranslations, translation
from pathlib import Path

from fleet_tui.text.language import speak

ENGLISH = "en"
"""The language of the texts in the code: it has no catalogue."""
LOCALES = Path(__file__).parents[1] / "locales"


def use_language(language: str) -> None:
    """Show all texts of this process in a language."""
    speak(NullTranslations() if language == ENGLISH else translation("fleet_tui", LOCALES, [language]))
