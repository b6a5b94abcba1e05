"""Profiles of simulated robots that navigate: how they differ from what is usual for their kind."""

from collections.abc import Mapping
from typing import Any


def profile(floors: int) -> Mapping[str, Any]:
    """Of several floors the robots say on which one they are, and each has a map."""
    return {"topics": {"floor": "/{robot}/floor", "map": "/{floor}/map"}} if floors > 1 else {}
