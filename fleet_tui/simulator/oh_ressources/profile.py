"""Profiles of simulated robots of the source's stack: how they differ from what is usual for their kind."""

from collections.abc import Mapping
from typing import Any


def profile(_floors: int) -> Mapping[str, Any]:
    """They tell whether they are paused."""
    return {"topics": {"paused": "/{robot}/paused"}}
