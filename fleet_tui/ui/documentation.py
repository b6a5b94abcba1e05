"""The pages of the documentation, which every installation has."""

import re
from collections.abc import Mapping
from pathlib import Path

PACKAGE = Path(__file__).parents[1]

_SUBJECT = re.compile(r"^For [^:]+: (.+?)\.(?: |$)")
_LINK = re.compile(r"\[([^\]]+)\]\([^)]*\)")


def pages() -> Mapping[str, Path]:
    """Return the pages by name: package data in a wheel, else those of the checkout."""
    shipped = PACKAGE / "docs_shipped"
    root = PACKAGE.parent
    files = [*shipped.glob("*.md")] or [
        *(root / "docs").glob("*.md"),
        root / "SECURITY.md",
        root / "CHANGELOG.md",
    ]
    return {path.stem.casefold(): path for path in sorted(files, key=lambda path: path.stem.casefold())}


def subject(page: str) -> str:
    """Return the subject of a page's text, which begins with `For READERS: SUBJECT.`"""
    opening = " ".join(page.split("\n\n")[1].split())
    found = _SUBJECT.search(opening)
    return _LINK.sub(r"\1", found[1] if found else opening).replace("`", "")


def headings(page: str) -> tuple[str, ...]:
    """Return the headings of a page's text."""
    return tuple(re.findall(r"^#+ (.+)$", page, re.MULTILINE))
