"""Style sheets parsed once: each app of a test would parse the same ones, which takes a tenth of its time."""

from typing import Any

from textual.css.model import RuleSet
from textual.css.stylesheet import Stylesheet

_parse = Stylesheet._parse_rules
_parsed: dict[object, list[RuleSet]] = {}


def _parse_once(sheet: Stylesheet, *arguments: Any, **named: Any) -> list[RuleSet]:
    """As Textual does within an app, which shares the rules too: nothing changes them."""
    key = frozenset(sheet._variables.items()), arguments, *sorted(named.items())
    if key not in _parsed:
        _parsed[key] = _parse(sheet, *arguments, **named)
    return _parsed[key]


def parse_styles_once() -> None:
    """Have every app of this process share them."""
    setattr(Stylesheet, _parse.__name__, _parse_once)  # Textual has no other way in
    RuleSet.__hash__ = object.__hash__  # type: ignore[method-assign]  # its own says the same, more slowly
