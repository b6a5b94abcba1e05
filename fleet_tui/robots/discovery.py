"""Discovery: lists of a bridge, and the robots that a kind recognises in them."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import NamedTuple

from fleet_tui.text.limits import LONGEST_NAME

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_./-]*")
"""ROS graph names, and harmless characters beside them."""


class Listed(NamedTuple):
    """The lists of a bridge: types of published topics and of services by name, empty if unknown, and the
    names of action servers. `heard`: types of topics that nodes only subscribe to. `messages` on topics whose
    messages alone name robots, by topic."""

    topics: Mapping[str, str]
    services: Mapping[str, str]
    actions: tuple[str, ...] = ()
    heard: Mapping[str, str] = {}
    messages: Mapping[str, tuple[object, ...]] = {}

    def sane(self) -> "Listed":
        """Leave out names and types that are invalid in a config: data from the wire may be anything."""
        return Listed(
            {name: type_ for name, type_ in self.topics.items() if _is_sane(name, type_)},
            {name: type_ for name, type_ in self.services.items() if _is_sane(name, type_)},
            tuple(name for name in self.actions if _is_sane(name, "")),
            {name: type_ for name, type_ in self.heard.items() if _is_sane(name, type_)},
            self.messages,
        )


@dataclass
class Discovery:
    """Robots of one kind with their floors, and the differences of its profile; `notes` are the decisions
    left to a person, by table. `candidates`: by table and key several names of which at most one was
    chosen. `absent`: keys of topics and services that don't exist. `more_floors`: those without a robot.
    `is_guess`: the only evidence is topics that other kinds have, too. `vehicles`: by robot the manufacturer
    and the serial number, of those on a broker."""

    robots: dict[str, list[str]] = field(default_factory=dict)
    topics: dict[str, str] = field(default_factory=dict)
    types: dict[str, str] = field(default_factory=dict)
    services: dict[str, str] = field(default_factory=dict)
    service_types: dict[str, str] = field(default_factory=dict)
    actions: dict[str, str] = field(default_factory=dict)
    live_maps: set[str] = field(default_factory=set)
    notes: dict[str, list[str]] = field(default_factory=dict)
    candidates: dict[tuple[str, str], list[str]] = field(default_factory=dict)
    absent: set[str] = field(default_factory=set)
    more_floors: list[str] = field(default_factory=list)
    is_guess: bool = False
    vehicles: dict[str, tuple[str, str]] = field(default_factory=dict)

    @property
    def floors(self) -> list[str]:
        """Every floor of any robot, and those without a robot."""
        return list(
            dict.fromkeys(floor for floors in (*self.robots.values(), self.more_floors) for floor in floors)
        )

    def note(self, table: str, text: str) -> None:
        """Leave a decision to a person."""
        self.notes.setdefault(table, []).append(text)

    def choose(self, table: str, key: str, candidates: Iterable[str], usual: str, type_: str) -> str:
        """Return the single candidate, or the one most like the usual name; leave the rest to a person."""
        candidates = sorted(candidates)
        if len(candidates) > 1:
            self.candidates[table, key] = candidates
        names = {template.rpartition("/")[2].lower(): template for template in candidates}
        near = get_close_matches(usual.rpartition("/")[2].lower(), names, n=1, cutoff=0.5)
        near = near or [name for name in names if key in name]
        chosen = names[near[0]] if near else candidates[0] if len(candidates) == 1 else ""
        if chosen:
            others = [one for one in candidates if one != chosen]
            if others:
                self.note(table, f"{key}: also possible: {', '.join(others)}")
        else:
            choice = f", one of {', '.join(candidates)}?" if candidates else f": no topic of type {type_}"
            self.note(table, f'{key} = "..."{choice}')
            if not candidates:
                self.absent.add(key)
        return chosen


def _is_sane(name: str, type_: str) -> bool:
    parts = name.split("/")
    is_name = len(name) <= LONGEST_NAME and not parts[0] and all(map(NAME.fullmatch, parts[1:]))
    return is_name and bool(NAME.fullmatch(type_ or "none"))
