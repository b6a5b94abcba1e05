"""The catalogues of the languages, and the messages that Babel finds in the code."""

import configparser
from functools import cache
from pathlib import Path

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po

ROOT = Path(__file__).parent.parent.parent
LOCALES = ROOT / "fleet_tui" / "locales"
LANGUAGES = sorted(path.name for path in LOCALES.iterdir() if path.is_dir())
KEYWORDS = {"Message": None, "tr": None, "N_": None, "counted": (1, 2)}
"""Functions with texts, and which of their arguments these are: the first, or one for a singular and its
plural."""


@cache
def catalogue(language: str) -> Catalog:
    with (LOCALES / language / "LC_MESSAGES" / "fleet_tui.po").open("rb") as file:
        return read_po(file)


@cache
def translations(language: str) -> dict[str, str]:
    """Every form of every message with its translation."""
    found: dict[str, str] = {}
    for message in catalogue(language):
        if message.id:
            found |= zip(_forms(message.id), _forms(message.string), strict=False)
    return found


def _forms(text: object) -> list[str]:
    """A text, or its singular and plural."""
    return (
        [text] if isinstance(text, str) else [str(form) for form in text] if isinstance(text, tuple) else []
    )


@cache
def extracted() -> frozenset[str | tuple[str, ...]]:
    """The messages of the code, a singular with its plural."""
    mapping = configparser.ConfigParser()
    mapping.read(ROOT / "babel.cfg")
    methods = [(pattern, method) for method, pattern in (one.split(": ") for one in mapping.sections())]
    found = extract_from_dir(ROOT, methods, keywords=KEYWORDS)
    return frozenset(message for _, _, message, _, _ in found if message)
