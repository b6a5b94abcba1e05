"""Profiles of simulated robots of oh_ressources: their differences from the defaults of the kind."""

from collections.abc import Mapping
from typing import Any


def profile(_floors: int) -> Mapping[str, Any]:
    """Return the topic on which they report a pause."""
    return {"topics": {"paused": "/{robot}/paused"}}
