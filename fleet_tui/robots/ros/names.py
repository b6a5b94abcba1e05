"""Names on the wire: the usual ones of a kind for topics, services, actions and fields, and those of a
site."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from fleet_tui.robots.profile import Profile, VertexRole

_IN_BRACES = re.compile(r"\{(\w+)\}")


def is_hidden(topic: str) -> bool:
    """Tell whether a topic belongs to an action: rosapi of ROS 2 does not list these, and all are latched."""
    return "/_action/" in topic


def cancel_service(action: str) -> str:
    """Return the name of the service that cancels goals of an action, as ROS 2 has it."""
    return f"{action}/_action/cancel_goal"


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The usual names of a kind. `topics`, `services` and `actions`: name with `{robot}` and `{floor}` in it,
    and type, by key; `floor_topics` are the keys of topics that exist once per floor. `fields`: by message
    or topic our names of its fields, each with its usual path in the message."""

    topics: Mapping[str, tuple[str, str]]
    floor_topics: frozenset[str]
    services: Mapping[str, tuple[str, str]]
    fields: Mapping[str, Mapping[str, str]]
    actions: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    scales: frozenset[str] = frozenset()
    refusals: tuple[str, ...] = ()
    vertex_types: Mapping[str, VertexRole] = field(default_factory=dict)
    requests: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    answers: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Names:
    """The names of one site's robots: those of its profile, else those of the kind. `table` is the config
    table of the profile."""

    vocabulary: Vocabulary
    profile: Profile
    table: str = "profile"

    def topic(self, key: str, robot: str, floor: str = "") -> str:
        """Return the name of a topic, empty if this site has none."""
        return _filled(self.profile.topics.get(key, self.vocabulary.topics[key][0]), robot, floor)

    def is_chosen(self, key: str) -> bool:
        """Tell whether a person named a topic or a service: of a robot without a namespace all usual names
        are in the profile."""
        given = {**self.profile.topics, **self.profile.services}
        usual, _ = {**self.vocabulary.topics, **self.vocabulary.services}[key]
        return key in given and given[key] != usual.replace("/{robot}", "")

    def type(self, key: str) -> str:
        """The ROS type of a topic."""
        return self.profile.types.get(key, self.vocabulary.topics[key][1])

    def service(self, key: str, robot: str) -> str:
        """Return the name of a service, empty if this site has none."""
        return _filled(self.profile.services.get(key, self.vocabulary.services[key][0]), robot)

    def service_type(self, key: str) -> str:
        """The ROS type of a service. Calls don't name it."""
        return self.profile.service_types.get(key, self.vocabulary.services[key][1])

    def request(self, key: str, values: Mapping[str, str]) -> Mapping[str, Any]:
        """Return the fields of a service's request, with values in the place of their names in braces."""
        chosen = self.profile.requests.get(key, self.vocabulary.requests.get(key, {}))
        return {name: _with_values(value, values) for name, value in chosen.items()}

    def answer(self, key: str) -> Mapping[str, Any]:
        """Return the fields of a service's answer that mean success, empty if it has none."""
        return self.profile.answers.get(key, self.vocabulary.answers.get(key, {}))

    def base_frame(self, robot: str) -> str:
        """Return the frame of a robot, empty for a usual one."""
        return _filled(self.profile.base_frame, robot).lstrip("/")

    def action(self, key: str, robot: str) -> str:
        """Return the name of an action, empty if this site has none."""
        return _filled(self.profile.actions.get(key, self.vocabulary.actions[key][0]), robot)

    def actions(self, robot: str) -> set[str]:
        """Return the names of all actions of a robot."""
        return {self.action(key, robot) for key in self.vocabulary.actions} - {""}

    def action_type(self, key: str) -> str:
        return self.profile.action_types.get(key, self.vocabulary.actions[key][1])

    def paths(self, message: str) -> dict[str, tuple[str, str]]:
        """Return by our name of a field its usual path in a message and the one at this site, if they
        differ."""
        usual = self.vocabulary.fields[message]
        chosen = {name: self.profile.fields.get(f"{message}.{name}", path) for name, path in usual.items()}
        return {name: (usual[name], path) for name, path in chosen.items() if path != usual[name]}

    def path(self, message: str, name: str) -> str:
        """The path of a field in a message at this site."""
        return self.profile.fields.get(f"{message}.{name}", self.vocabulary.fields[message][name])

    def scale(self, key: str) -> float:
        """The factor by which a number of a topic is multiplied."""
        return self.profile.scales.get(key, 1.0)

    def role(self, vertex_type: str) -> VertexRole:
        """Return the role of a vertex by its type on the wire."""
        known = self.profile.vertex_types
        return (self.vocabulary.vertex_types if known is None else known).get(vertex_type, "plain")

    @property
    def refusals(self) -> tuple[str, ...]:
        """Return patterns of a robot's words of refusal."""
        chosen = self.profile.refusals
        return self.vocabulary.refusals if chosen is None else chosen


def _with_values(value: Any, values: Mapping[str, str]) -> Any:
    """Fill in the texts of a field, however deep."""
    if isinstance(value, str):
        # In one pass: a value in braces is not filled in again.
        return _IN_BRACES.sub(lambda found: values.get(found[1], found[0]), value)
    if isinstance(value, Mapping):
        return {name: _with_values(part, values) for name, part in value.items()}
    return [_with_values(part, values) for part in value] if isinstance(value, list) else value


def _filled(template: str, robot: str, floor: str = "") -> str:
    return template.replace("{robot}", robot).replace("{floor}", floor)
