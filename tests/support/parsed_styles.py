"""Style sheets parsed once, and the rules of a widget found once: each app of a test would do it anew, which
takes a third of its time."""

from typing import Any, cast

from textual.css.model import RuleSet
from textual.css.styles import RulesMap
from textual.css.stylesheet import Stylesheet
from textual.dom import DOMNode

_parse, _apply = Stylesheet._parse_rules, Stylesheet.apply
_parsed: dict[object, list[RuleSet]] = {}


class _Found(dict[tuple[Any, ...], RulesMap]):
    """The rules of the widgets of any app with the same style sheet, as Textual keeps them while it goes
    through one app: by what they are and where they stand, not by the very parent."""

    def get(self, key: tuple[Any, ...], default: Any = None) -> Any:
        return super().get(_placed(key), default)

    def __setitem__(self, key: tuple[Any, ...], rules: RulesMap) -> None:
        super().__setitem__(_placed(key), rules)


_found: dict[tuple[int, ...], _Found] = {}
_of_sheets: dict[int, tuple[list[RuleSet], _Found]] = {}


def _placed(key: tuple[Any, ...]) -> tuple[Any, ...]:
    parent, *what = key
    path = () if parent is None else cast(DOMNode, parent).css_path_nodes
    above = [(one._css_type_name, one._id, one.classes, one._pseudo_classes_cache_key) for one in path]
    return (*above, *what)


def _found_in(sheet: Stylesheet) -> _Found:
    rules = sheet.rules
    known = _of_sheets.get(id(rules))
    if known is None or known[0] is not rules:
        known = rules, _found.setdefault(tuple(map(id, rules)), _Found())
        _of_sheets[id(rules)] = known
    return known[1]


def _apply_found(
    sheet: Stylesheet, node: DOMNode, *, animate: bool = False, cache: dict[Any, Any] | None = None
) -> None:
    _apply(sheet, node, animate=animate, cache=_found_in(sheet))


def _parse_once(sheet: Stylesheet, *arguments: Any, **named: Any) -> list[RuleSet]:
    """As Textual does within an app, which shares the rules too: nothing changes them."""
    key = frozenset(sheet._variables.items()), arguments, *sorted(named.items())
    if key not in _parsed:
        _parsed[key] = _parse(sheet, *arguments, **named)
    return _parsed[key]


def parse_styles_once() -> None:
    """Have every app of this process share them."""
    setattr(Stylesheet, _parse.__name__, _parse_once)  # Textual has no other way in
    setattr(Stylesheet, _apply.__name__, _apply_found)
    RuleSet.__hash__ = object.__hash__  # type: ignore[method-assign]  # its own says the same, more slowly
