"""Help tells of the keys and words there are."""

from fleet_tui.screens.help import notes
from tests.support.kinds import BARE, FULL


def test_help_tells_of_what_can_be_typed() -> None:
    assert "pause all" in notes(FULL) and "cargo on board to B" in notes(FULL)
    for word in ("pause", "cancel", "clear", "cargo"):
        assert word not in notes(BARE).partition("Confirmations: ")[0]
    assert "directly to B" in notes(BARE)
