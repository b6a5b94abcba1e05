"""Checks of profiles: names unknown to a kind of robots, and ambiguous topics."""

import math
import re
from collections.abc import Iterator, Mapping

import msgspec

from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.registry import KINDS, kind_of
from fleet_tui.adapters.ros.names import Vocabulary
from fleet_tui.adapters.ros.type_names import same_type
from fleet_tui.config.entries import DEFAULT_LINK
from fleet_tui.config.fleet import OF_BROKERS, adapters_of, profile_of, shared_steering, shared_topics
from fleet_tui.config.schema import Config, Link, link_key
from fleet_tui.errors import did_you_mean

TAKE_FIELDS = ("std_srvs/SetBool", "nav2_msgs/ManageLifecycleNodes", "lifecycle_msgs/ChangeState")
"""Types of services on which `{}`, all that a pause sends, is a command of its own: to start, to resume."""


def check_profiles(config: Config) -> Iterator[str]:
    """Yield one line for each problem of a profile, or of a reference to one."""
    problems = [*_references(config), *_profile("profile", config.profile)]
    for name, profile in config.profiles.items():
        problems += _profile(f"profiles.{name}", profile)
    yield from problems
    if not problems:
        known = {DEFAULT_LINK, *config.links}
        robots = [
            robot for robot in config.robots if robot.link in known and _is_known(config, robot.profile)
        ]
        config = msgspec.structs.replace(config, robots=robots)
        adapters = adapters_of(config)
        yield from shared_topics(config, adapters)
        yield from shared_steering(config, adapters)


def _is_known(config: Config, name: str) -> bool:
    return not name or name in config.profiles or name in KINDS


def _references(config: Config) -> Iterator[str]:
    links = {DEFAULT_LINK: config.rosbridge, **config.links}
    named = [(f"{link_key(name)}.profile", link.profile) for name, link in links.items()]
    named += [(f"robots[{n}].profile", robot.profile) for n, robot in enumerate(config.robots)]
    yield from _transports(config, links)
    for where, name in named:
        if not _is_known(config, name):
            yield f"{where}: unknown kind or profile {name!r}{did_you_mean(name, [*config.profiles, *KINDS])}"


def _transports(config: Config, links: Mapping[str, Link]) -> Iterator[str]:
    """Check that the kind of each robot is one of its link's transport."""
    for n, robot in enumerate(config.robots):
        if robot.link not in links or not _is_known(config, robot.profile or links[robot.link].profile):
            continue
        kind = kind_of(profile_of(config, robot)[1])
        link = links[robot.link]
        if kind in KINDS and (kind == OF_BROKERS) != link.is_broker:
            where = f"{link_key(robot.link)}, which is {link.scheme}://"
            yield f"robots[{n}]: kind {kind} on {where}: correct the profile or the link"
        for key in ("manufacturer", "serial"):
            if set(getattr(robot, key)) & set("/+#\0"):
                yield f"robots[{n}].{key}: a level of a topic has no / + or #"


def _profile(where: str, profile: Profile) -> Iterator[str]:
    if profile.name and profile.kind and profile.name != profile.kind:
        yield f"{where}.name: {profile.name!r} and kind {profile.kind!r} are the same setting: remove one"
    kind = kind_of(profile)
    if kind not in KINDS:
        key = "kind" if profile.kind else "name"
        yield f"{where}.{key}: unknown kind {kind!r}{did_you_mean(kind, KINDS)}"
        return
    known = KINDS[kind].vocabulary
    yield from _unknown_keys(where, profile, known)
    yield from _numbers(where, profile)
    yield from _placeholders(where, profile, known.floor_topics)
    yield from _refusals(where, profile)
    yield from _pauses(where, profile)
    yield from _settings(where, profile, kind)


def _pauses(where: str, profile: Profile) -> Iterator[str]:
    for key in ("pause", "resume"):
        type_ = profile.service_types.get(key, "")
        if any(same_type(type_, other) for other in TAKE_FIELDS):
            remedy = "name a service of std_srvs/Trigger or std_srvs/Empty"
            yield f"{where}.service_types.{key}: a {key} can't fill the fields of {type_}: {remedy}"


def _unknown_keys(where: str, profile: Profile, known: Vocabulary) -> Iterator[str]:
    fields = {f"{message}.{field}" for message, names in known.fields.items() for field in names}
    tables: tuple[tuple[str, Mapping[str, object], object], ...] = (
        ("topics", profile.topics, known.topics),
        ("types", profile.types, known.topics),
        ("services", profile.services, known.services),
        ("service_types", profile.service_types, known.services),
        ("actions", profile.actions, known.actions),
        ("action_types", profile.action_types, known.actions),
        ("requests", profile.requests, known.requests),
        ("answers", profile.answers, known.answers),
        ("fields", profile.fields, fields),
        ("scales", profile.scales, known.scales),
        ("silence", profile.silence, set(known.topics) - known.floor_topics),
    )
    for table, given, names in tables:
        assert isinstance(names, Mapping | set | frozenset)
        for key in given:
            if key not in names:
                yield f"{where}.{table}.{key}: unknown key{did_you_mean(key, names)}"


def _numbers(where: str, profile: Profile) -> Iterator[str]:
    for key, scale in profile.scales.items():
        if not 0.0 < scale < math.inf:
            yield f"{where}.scales.{key}: {scale:g} is not a factor: use a number above 0"
    for key, seconds in profile.silence.items():
        if not seconds > 0.0:
            yield f"{where}.silence.{key}: {seconds:g} is not a duration: use seconds above 0"


def _refusals(where: str, profile: Profile) -> Iterator[str]:
    for n, pattern in enumerate(profile.refusals or ()):
        try:
            re.compile(pattern)
        except (re.error, OverflowError, RecursionError) as problem:
            yield f"{where}.refusals[{n}]: {pattern!r} is not a regular expression: {problem}"


def _placeholders(where: str, profile: Profile, floor_topics: frozenset[str]) -> Iterator[str]:
    tables = (("topics", profile.topics), ("services", profile.services), ("actions", profile.actions))
    for table, given in tables:
        for key, template in given.items():
            for name in re.findall(r"\{([^}]*)\}", template):
                if name not in (("robot", "floor") if key in floor_topics else ("robot",)):
                    yield f"{where}.{table}.{key}: {{{name}}} is not available here"


def _settings(where: str, profile: Profile, kind: str) -> Iterator[str]:
    """Check the tables that belong to single kinds."""
    for name, table in profile.settings.items():
        struct = KINDS[name].settings if name in KINDS else None
        if name != kind or struct is None:
            yield f"{where}.{name}: not a table of kind {kind}"
            continue
        known = [field.name for field in msgspec.structs.fields(struct)]
        yield from (
            f"{where}.{name}.{key}: unknown key{did_you_mean(key, known)}"
            for key in table
            if key not in known
        )
        try:
            msgspec.convert(table, struct)
        except msgspec.ValidationError as problem:
            yield f"{where}.{name}: {problem}"
