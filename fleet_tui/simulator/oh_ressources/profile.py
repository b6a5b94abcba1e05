"""Profiles of simulated robots of oh_ressources: their differences from the defaults of the kind."""

from collections.abc import Mapping
from typing import Any


def profile(_floors: int) -> Mapping[str, Any]:
    """Return the topics on which they report a pause, and those of set-up."""
    topics = ("paused", "goal", "goal_cancel", "scan", "mode")
    return {
        "topics": {
            **{key: f"/{{robot}}/{key}" for key in topics},
            "initial_pose": "/{robot}/initialpose",
            "drive": "/{robot}/cmd_vel",
            "camera": "/{robot}/camera/image_raw/compressed",
            **{key: f"/{{robot}}/{{floor}}/{key}" for key in ("graph_save", "labels_save")},
        },
        "services": {
            **dict.fromkeys(("mapping_on", "mapping_off"), "/{robot}/set_mapping"),
            "map_save": "/{robot}/save_map",
        },
    }
