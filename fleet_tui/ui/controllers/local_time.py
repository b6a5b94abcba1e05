"""Times of day of this machine."""

from datetime import datetime

from fleet_tui.text.language import Message


def since_text(wall: float) -> str:
    """Return Unix seconds as a local time: of today, else with the date."""
    try:
        at = datetime.fromtimestamp(wall)
    except (OverflowError, ValueError, OSError):
        return Message("no time")
    return f"{at:%H:%M:%S}" if at.date() == datetime.now().date() else f"{at:%m-%d %H:%M}"
