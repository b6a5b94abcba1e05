"""Details of a command's outcome, as one line."""

from fleet_tui.text.language import EMPTY, Message


def detail_text(detail: str) -> Message:
    """Return the text of a detail after an outcome: `confirmed by the robot`, `refused (no cargo)`; empty for
    none."""
    if not detail:
        return EMPTY
    if detail.startswith("by "):
        return Message(" {detail}", detail=detail)
    return Message(" ({detail})", detail=detail)
