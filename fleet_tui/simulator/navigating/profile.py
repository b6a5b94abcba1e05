"""Profiles of simulated robots that navigate: their differences from the defaults of the kind."""

from collections.abc import Mapping
from typing import Any


def profile(floors: int) -> Mapping[str, Any]:
    """Return the topic of the mode, and those of the robot's floor and of a map per floor, if there are
    several floors."""
    several = {"floor": "/{robot}/floor", "map": "/{floor}/map"} if floors > 1 else {}
    return {"topics": {"mode": "/{robot}/mode", **several}}
