"""The one rule by which typed text never becomes commands.

- Text keys are the printable ones and Enter. All others (Esc, arrows, F12, Ctrl) always act.
- In a text field they are text. Every list that can be searched is a text field with its matches.
- Elsewhere they act, unless they follow typed text without a gap of `GAP`: a word whose form closed in the
  middle of it is dropped to its end, and a held Enter with it.
- After the console or the terminal stood still for `STANDSTILL`, the keys that waited are dropped to their
  end, in fields, too: the screen they were typed at has gone. A key that pauses all robots acts if it alone
  waited.
- Esc ends both at once.
"""

import math
from enum import Enum

GAP = 0.5
"""Seconds without a text key after which the next one is meant as a command."""
STANDSTILL = 2.0
"""Seconds in which nothing could be shown after which waiting keys are dropped."""


class Fate(Enum):
    ACTS = "acts"
    DROPPED = "dropped"
    WAITS = "waits"
    """It acts after `GAP`, unless another text key comes before: `is_alone` tells."""


class Typing:
    """Judges keys in their order, by the times at which they arrived (monotonic seconds)."""

    def __init__(self) -> None:
        self._typed_at = -math.inf
        """The arrival of the last text key that was text or dropped."""
        self._is_blind = False
        self.dropped = 0
        """Keys dropped since the last one that acted."""
        self.is_alone = False
        """A key that pauses all robots waits, and no other text key has come."""

    @property
    def is_blind(self) -> bool:
        """Tell whether keys are dropped because of a standstill."""
        return self._is_blind

    def stood_still(self, until: float) -> None:
        """Drop the keys that waited while nothing could be shown."""
        if self._is_blind and until - self._typed_at < GAP:
            return
        self._typed_at = until
        self._is_blind = True
        self.dropped = 0
        self.is_alone = False

    def judge(self, key: str, is_text: bool, at: float, in_field: bool, pauses_all: bool = False) -> Fate:
        """Return the fate of a key. `in_field`: a text field has the focus; `pauses_all`: it is a text key
        that pauses all robots."""
        if key == "escape":
            self._end()
            return Fate.ACTS
        if not is_text:
            return Fate.ACTS
        if at - self._typed_at >= GAP:
            self._end()
        if self._is_blind and pauses_all and not in_field and (self.is_alone or not self.dropped):
            self._typed_at = max(at, self._typed_at)
            self.is_alone = True
            return Fate.WAITS
        if self._is_blind or (not in_field and at - self._typed_at < GAP):
            # A key that waited came before the end of the standstill, and ends nothing.
            self._typed_at = max(at, self._typed_at)
            self.dropped += 1 + self.is_alone
            self.is_alone = False
            return Fate.DROPPED
        self._typed_at = at if in_field else -math.inf
        self.dropped = 0
        return Fate.ACTS

    def _end(self) -> None:
        self._typed_at = -math.inf
        self._is_blind = False
        self.dropped = 0
        self.is_alone = False
