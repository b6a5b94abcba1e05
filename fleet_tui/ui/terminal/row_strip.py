"""A row of a widget as a Textual strip."""

from collections.abc import Iterable, Sequence

from textual.strip import Strip


class RowStrip(Strip):
    """Uncut it holds no reference to itself: a cycle would be garbage that is collected minutes later."""

    __slots__ = ()

    def divide(self, cuts: Iterable[int]) -> Sequence[Strip]:
        """Return the parts between cuts."""
        cuts = list(cuts)
        return [self] if cuts == [self.cell_length] else super().divide(cuts)
