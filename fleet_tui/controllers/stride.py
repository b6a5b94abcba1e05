"""The step of a panning key: it grows while the key is held."""

from dataclasses import dataclass

_REPEATS = 0.15  # seconds; presses closer than this are from a held key
_LONGEST = 4


@dataclass(frozen=True, slots=True)
class Stride:
    """The last step of a panning key: its direction, its time (seconds), the duration of the hold."""

    way: tuple[int, int] = (0, 0)
    at: float = 0.0
    repeats: int = 0

    def then(self, way: tuple[int, int], now: float) -> "Stride":
        """Return the step after this one."""
        held = way == self.way and now - self.at < _REPEATS
        return Stride(way, now, self.repeats + 1 if held else 0)

    @property
    def times(self) -> int:
        """Return the number of single steps of this one: it grows up to a limit."""
        return min(1 + self.repeats // 3, _LONGEST)
