"""A row of a widget as a strip of Textual's."""

from collections.abc import Iterable, Sequence

from textual.strip import Strip


class RowStrip(Strip):
    """Uncut it keeps no note of itself: rows that do would be garbage which is found minutes later."""

    __slots__ = ()

    def divide(self, cuts: Iterable[int]) -> Sequence[Strip]:
        """The parts between cuts."""
        cuts = list(cuts)
        return [self] if cuts == [self.cell_length] else super().divide(cuts)
