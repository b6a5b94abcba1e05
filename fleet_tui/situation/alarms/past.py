"""What a list of the past says of an alarm."""

import re

from fleet_tui.model.alarm import Alarm
from fleet_tui.text.language import Message

_FIGURE = re.compile(r"(?<![\w.])[\d.]+ (?:s|min|h|%)(?!\w)")


def told(alarm: Alarm) -> Message:
    """Return its text as it was at its time, unless its cause came later: a duration that counts on would
    contradict that."""
    has_news = _FIGURE.sub("", alarm.first_text) != _FIGURE.sub("", alarm.text)
    return alarm.text if has_news else alarm.first_text
