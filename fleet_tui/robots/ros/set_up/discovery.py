"""Names of set-up among the names that a bridge lists, for kinds that have none by default."""

from collections.abc import Iterator, Mapping

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.ros.names import Vocabulary
from fleet_tui.robots.ros.type_names import same_type

Endings = Mapping[str, tuple[str, ...]]
"""Usual names below a robot's own, by key."""
TOPICS: Endings = {
    "scan": ("scan", "base_scan"),
    "path": ("plan", "move_base/NavfnROS/plan", "move_base/GlobalPlanner/plan"),
    "camera": ("camera/image_raw/compressed", "camera/color/image_raw/compressed", "image_raw/compressed"),
    "initial_pose": ("initialpose",),
}
SERVICES: Endings = {
    "localise": ("global_localization", "reinitialize_global_localization"),
    "settle": ("request_nomotion_update",),
}
PROPOSED_TOPICS: Endings = {
    "goal": ("move_base_simple/goal", "goal"),
    "goal_cancel": ("move_base/cancel", "goal_cancel"),
    "mode": ("mode", "{floor}/mode"),
    "drive": ("cmd_vel",),
    "graph_save": ("{floor}/graph_save", "{floor}/save_graph"),
    "labels_save": ("{floor}/labels_save", "{floor}/save_labels"),
}
PROPOSED_SERVICES: Endings = {
    "mapping_on": ("set_mapping", "enable_mapping"),
    "mapping_off": ("set_mapping", "enable_mapping"),
    "map_save": ("slam_toolbox/save_map", "save_map"),
    "map_pose_graph": ("slam_toolbox/serialize_map",),
}
"""Those that drive a robot, change how it localises or write to its disk are left to a person."""


def find_set_up(found: Discovery, listed: Listed, vocabulary: Vocabulary) -> None:
    """Name the topics and services of set-up that exist under a usual name with the expected type."""
    topics = {**listed.heard, **listed.topics}
    found.topics |= dict(_there(found, topics, TOPICS, vocabulary.topics))
    found.services |= dict(_there(found, listed.services, SERVICES, vocabulary.services))
    for table, names, endings, known in (
        ("topics", topics, PROPOSED_TOPICS, vocabulary.topics),
        ("services", listed.services, PROPOSED_SERVICES, vocabulary.services),
    ):
        for key, template in _there(found, names, endings, known):
            found.note(table, f'{key} = "{template}"   # found; see: fleet-tui docs setting-up')


def _there(
    site: Discovery, names: Mapping[str, str], endings: Endings, known: Mapping[str, tuple[str, str]]
) -> Iterator[tuple[str, str]]:
    """Yield key and template of the first usual name that any robot has, if its kind knows the key."""
    for key, usual in endings.items():
        _, type_ = known.get(key, ("", ""))
        for ending in usual if type_ else ():
            there = (
                f"/{robot}/{ending.replace('{floor}', floor)}"
                for robot, floors in site.robots.items()
                for floor in (floors if "{floor}" in ending else ("",))
            )
            if any(same_type(names.get(name, ""), type_) for name in there):
                yield key, f"/{{robot}}/{ending}"
                break
