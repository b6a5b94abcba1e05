"""Details of a command's outcome, as one line."""


def detail_text(detail: str) -> str:
    """Return the text of a detail after an outcome: `confirmed by the robot`, `refused (no cargo)`; empty for
    none."""
    if not detail:
        return ""
    return f" {detail}" if detail.startswith("by ") else f" ({detail})"
