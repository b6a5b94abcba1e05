"""Choices that discovery leaves to a person, each with its options. Pure."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

from fleet_tui.links.discovery.finding import listed
from fleet_tui.links.discovery.recognition import Found, assigned, contested
from fleet_tui.robots.discovery import Discovery
from fleet_tui.robots.registry import KINDS

Id = tuple[str, ...]
Answers = Mapping[Id, str]
"""The options chosen by a person, by question."""
ANY_FLOOR = ""


class Choice(NamedTuple):
    """A question in a few words; `chosen` is one of the options, empty for none."""

    id: Id
    text: str
    options: tuple[str, ...]
    chosen: str

    def __str__(self) -> str:
        """Return the question with its current value, and the other options."""
        others = [option for option in self.options if option != self.chosen]
        return f"{self.text}: {self.chosen or 'unknown'}, possibly {', '.join(others)}"


def decided(claims: Found, answers: Answers) -> Found:
    """Return the findings, with these answers and the best guess for everything else."""
    kinds = {
        robot: answers["kind", *robots]
        for robots in contested(claims).values()
        for robot in robots
        if ("kind", *robots) in answers
    }
    return {kind: _answered(kind, one, answers) for kind, one in assigned(claims, kinds).items()}


def _answered(kind: str, found: Discovery, answers: Answers) -> Discovery:
    robots = {
        robot: [chosen] if (chosen := answers.get(("floor", robot), ANY_FLOOR)) else floors
        for robot, floors in found.robots.items()
    }
    topics, services = dict(found.topics), dict(found.services)
    answered = replace(found, robots=robots, more_floors=found.floors, topics=topics, services=services)
    for table, key in found.candidates:
        if name := answers.get((table, kind, key)):
            getattr(answered, table)[key] = name
    return answered


def choices_of(claims: Found, found: Found, frames: Mapping[str, str], answers: Answers) -> list[Choice]:
    """Return every open or answered question, with its current value."""
    choices = list(_kinds(claims, found))
    for kind, one in found.items():
        choices += _names(kind, one)
        choices += _floors(kind, claims[kind], one, answers)
    return [*choices, *_frames(claims, frames, answers)]


def _kinds(claims: Found, found: Found) -> Iterator[Choice]:
    for kinds, robots in contested(claims).items():
        chosen = next(kind for kind, one in found.items() if robots[0] in one.robots)
        yield Choice(("kind", *robots), f"kind of {listed(robots)}", kinds, chosen)


def _names(kind: str, found: Discovery) -> Iterator[Choice]:
    for (table, key), candidates in found.candidates.items():
        chosen = getattr(found, table).get(key, "")
        text = f"{table.removesuffix('s').replace('_', ' ')} of {key} ({kind})"
        yield Choice((table, kind, key), text, tuple(candidates), chosen)


def _floors(kind: str, claim: Discovery, found: Discovery, answers: Answers) -> Iterator[Choice]:
    """Ask for the floor of each robot that has several and does not report its own."""
    topics = KINDS[kind].vocabulary.topics
    if "floor" not in topics or topics["floor"][0] or found.topics.get("floor"):
        return
    for robot in found.robots:
        floors = claim.robots[robot]
        if len(floors) > 1:
            chosen = answers.get(("floor", robot), ANY_FLOOR)
            yield Choice(("floor", robot), f"floor of {robot}", tuple(floors), chosen)


def placed(answers: Answers) -> dict[str, str]:
    """Return the frame of each floor that a person assigned."""
    return {floor: id_[1] for id_, floor in answers.items() if id_[0] == "frame"}


def lacks(found: Found) -> list[str]:
    """Return the missing settings without which robots can't be shown."""
    return [
        f"no pose topic for {kind} robots: listed, but not on the map"
        for kind, one in found.items()
        if ("pose" in one.absent or one.topics.get("pose") == "")
        and "tf" not in KINDS[kind].vocabulary.topics  # else transforms may tell it
    ]


def strange_frames(found: Found, frames: Mapping[str, str]) -> list[str]:
    """Return the frames of poses that are not names of floors."""
    return sorted(set(frames.values()) - set(floors_of(found)) - {""})


def floors_of(found: Found) -> list[str]:
    """Return every floor of any kind."""
    return list(dict.fromkeys(floor for one in found.values() for floor in one.floors))


def _frames(claims: Found, frames: Mapping[str, str], answers: Answers) -> Iterator[Choice]:
    floors = tuple(floors_of(claims))
    if len(floors) > 1:
        for frame in strange_frames(claims, frames):
            chosen = answers.get(("frame", frame), "")
            yield Choice(("frame", frame), f"floor of frame {frame}", floors, chosen)
