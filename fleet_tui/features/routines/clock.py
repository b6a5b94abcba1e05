"""The local clock."""

import time
from datetime import datetime, timedelta

from fleet_tui.features.routines.blocks import DayTime


def next_time(at: DayTime, wall: float | None = None) -> float:
    """Return the Unix second at which the local clock next shows a time, from a Unix second on, by default
    from now on."""
    now = datetime.fromtimestamp(time.time() if wall is None else wall)
    then = now.replace(hour=at.minute // 60, minute=at.minute % 60, second=0, microsecond=0)
    # A naive time is local: the day after a change of the clock it is another number of seconds away.
    return (then if then >= now else then + timedelta(days=1)).timestamp()


def clock_text(wall: float) -> str:
    """Return Unix seconds as local time."""
    return f"{datetime.fromtimestamp(wall):%H:%M:%S}"
