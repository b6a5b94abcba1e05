"""Matches of a field, listed below it: the field keeps the focus, one match is marked."""

from collections.abc import Iterable

from textual.widgets import OptionList


class Matches(OptionList, can_focus=False):
    """`marked` is the index of the match that Enter takes."""

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id, markup=False)

    def show(self, texts: Iterable[str], mark: bool = True) -> None:
        """List these, the first one marked unless none may be taken yet."""
        self.clear_options()
        self.add_options(list(texts))
        self.highlighted = 0 if mark and self.option_count else None

    def step(self, rows: int) -> None:
        """Mark another one."""
        (self.action_cursor_down if rows > 0 else self.action_cursor_up)()

    @property
    def marked(self) -> int:
        """Return the index of the marked match, 0 without one."""
        return self.highlighted or 0
