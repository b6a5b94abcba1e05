"""The catalogues of the languages, and the messages that Babel finds in the code."""

import ast
import configparser
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.pofile import read_po
from babel.util import pathmatch

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
def methods() -> list[tuple[str, str]]:
    """The patterns of babel.cfg with what is done with their files."""
    mapping = configparser.ConfigParser()
    mapping.read(ROOT / "babel.cfg")
    return [(pattern, method) for method, pattern in (one.split(": ") for one in mapping.sections())]


@cache
def extracted() -> frozenset[str | tuple[str, ...]]:
    """The messages of the code, a singular with its plural."""
    found = extract_from_dir(ROOT, methods(), keywords=KEYWORDS)
    return frozenset(message for _, _, message, _, _ in found if message)


def called() -> Iterator[tuple[str, str]]:
    """Yield the literal texts of the same functions, with their modules."""
    for path in (ROOT / "fleet_tui").rglob("*.py"):
        name = path.relative_to(ROOT).as_posix()
        if next(method for pattern, method in methods() if pathmatch(pattern, name)) == "ignore":
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(func=ast.Name(id=function), args=[ast.Constant(value=str(text)), *_]):
                    if function in KEYWORDS and text:
                        yield name, text
