"""Durations as typed: 90, 45s, 30m, 8h, 1d."""

import re
from typing import Any

import click

_SECONDS = {"": 1, "s": 1, "m": 60, "h": 3600, "d": 86_400}
LONGEST = 366 * 86_400.0


class DurationParam(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in newer versions of click only
    """Seconds, as a float."""

    name = "duration"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Parse the typed text."""
        found = re.fullmatch(r"(\d{1,9}(?:\.\d{1,3})?)([smhd]?)", str(value))
        seconds = float(found[1]) * _SECONDS[found[2]] if found else 0.0
        if not 0.0 < seconds <= LONGEST:
            self.fail(f"{value!r} is not a duration: use 45s, 30m, 8h or 1d", param, ctx)
        return seconds
