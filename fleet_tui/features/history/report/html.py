"""Elements of a page. Everything that is said in them is text: the library escapes it."""

from collections.abc import Iterable, Sequence
from xml.etree.ElementTree import Element

from fleet_tui.text.sanitize import sanitize

Child = Element | str
Attribute = str | float


def element(tag: str, *children: Child, **attributes: Attribute) -> Element:
    """Return an element. `class_` is the attribute class, `stroke_width` is stroke-width."""
    made = Element(tag, {_name(name): _text(value) for name, value in attributes.items()})
    for child in children:
        if not isinstance(child, str):
            made.append(child)
        elif len(made):
            made[-1].tail = (made[-1].tail or "") + sanitize(child)
        else:
            made.text = (made.text or "") + sanitize(child)
    return made


def table(heads: Sequence[str], rows: Iterable[Sequence[str]], numbers_from: int = 1) -> Element:
    """Return a table; its columns from `numbers_from` on are aligned to the right."""
    return element(
        "table",
        element("thead", _row("th", heads, numbers_from)),
        element("tbody", *(_row("td", row, numbers_from) for row in rows)),
    )


def _row(tag: str, cells: Sequence[str], numbers_from: int) -> Element:
    return element(
        "tr",
        *(
            element(tag, cell, **({"class_": "n"} if n >= numbers_from else {}))
            for n, cell in enumerate(cells)
        ),
    )


def _name(name: str) -> str:
    return name.rstrip("_").replace("_", "-") if name != "viewBox" else name


def _text(value: Attribute) -> str:
    return sanitize(value) if isinstance(value, str) else f"{value:.5g}"
