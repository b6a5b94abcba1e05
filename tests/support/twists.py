"""Twists as a bridge has them."""

from typing import Any


def twist(ahead: float = 0.0, sideways: float = 0.0, turning: float = 0.0) -> dict[str, Any]:
    return {"linear": {"x": ahead, "y": sideways, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": turning}}
