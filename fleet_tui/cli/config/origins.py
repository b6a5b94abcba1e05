"""The `config show` command: every effective value and its origin."""

import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui.config.access import without_secrets
from fleet_tui.config.schema import NOT_IN_FILE, Config
from fleet_tui.keys.keymap import keymap
from fleet_tui.records.audit.log import operator_name
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS, kind_of
from fleet_tui.robots.ros.names import Names

Found = tuple[str, object]

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?")
_KEY = re.compile(
    r"\s*((?:[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*')(?:\s*\.\s*(?:[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*'))*)\s*="
)


def values(config: Config) -> Iterator[Found]:
    """Return every key that can be set, with its effective value, unless that is secret."""
    config = without_secrets(config)
    for field in msgspec.structs.fields(Config):
        value = getattr(config, field.name)
        match field.name:
            case name if name in NOT_IN_FILE:
                continue
            case "profile" | "profiles":
                named = {"profile": value} if field.name == "profile" else value
                for name, profile in named.items():
                    yield from _profile(name if value is profile else f"profiles.{name}", profile)
            case "keys":
                chosen = keymap(config.keys)[0]
                yield from ((f"keys.{id_}", ",".join(keys)) for id_, keys in chosen.items())
            case "links":
                for name, link in value.items():
                    yield from _struct(f"links.{name}", link)
            case "floors" | "robots" | "programs":
                for n, entry in enumerate(value):
                    yield from _struct(f"{field.name}[{n}]", entry)
            case _:
                yield from _struct(field.name, value)


def _struct(where: str, value: msgspec.Struct) -> Iterator[Found]:
    for name in value.__struct_fields__:
        yield f"{where}.{name}", getattr(value, name)


def _profile(where: str, profile: Profile) -> Iterator[Found]:
    names = Names(KINDS[kind_of(profile)].vocabulary, profile)
    known = names.vocabulary
    tables: dict[str, Iterator[Found]] = {
        "topics": ((key, names.topic(key, "{robot}", "{floor}")) for key in known.topics),
        "types": ((key, names.type(key)) for key in known.topics),
        "services": ((key, names.service(key, "{robot}")) for key in known.services),
        "service_types": ((key, names.service_type(key)) for key in known.services),
        "actions": ((key, names.action(key, "{robot}")) for key in known.actions),
        "action_types": ((key, names.action_type(key)) for key in known.actions),
        "fields": (
            (f"{message}.{field}", names.path(message, field))
            for message, fields in sorted(known.fields.items())
            for field in fields
        ),
        "scales": ((key, names.scale(key)) for key in sorted(known.scales)),
        "silence": iter(profile.silence.items()),
        "settings": iter(profile.settings.items()),
    }
    yield f"{where}.kind", kind_of(profile)
    for table, found in tables.items():
        prefix = where if table == "settings" else f"{where}.{table}"
        yield from ((f"{prefix}.{key}", value) for key, value in found)
    yield f"{where}.refusals", names.refusals
    chosen = profile.vertex_types
    yield f"{where}.vertex_types", known.vertex_types if chosen is None else chosen
    yield f"{where}.directed", profile.directed
    yield f"{where}.origin", profile.origin


def lines_of(text: str) -> dict[str, int]:
    """Return line number by key path, as far as the text of the lines shows."""
    found, where, counts = dict[str, int](), "", dict[str, int]()
    for number, line in enumerate(text.splitlines(), 1):
        header, key = _HEADER.match(line), _KEY.match(line)
        if key:
            path = ".".join(part for part in (where, _plain(key.group(1))) if part)
            found.setdefault(path, number)
        elif header:
            where = _plain(header.group(2))
            if header.group(1) == "[[":
                counts[where] = counts.get(where, -1) + 1
                where = f"{where}[{counts[where]}]"
            found.setdefault(where, number)
    return found


def _plain(key: str) -> str:
    """Return a dotted key without quotes and spaces."""
    parts = re.findall(r"\"[^\"]*\"|'[^']*'|[A-Za-z0-9_-]+", key)
    return ".".join(part.strip("\"'") for part in parts)


def given(table: Mapping[str, Any], where: str = "") -> Iterator[str]:
    """Return the key paths set in a config file."""
    for name, value in table.items():
        path = f"{where}.{name}" if where else name
        if isinstance(value, Mapping):
            yield from given(value, path)
        elif isinstance(value, list) and value and isinstance(value[0], Mapping):
            for n, entry in enumerate(value):
                yield from given(entry, f"{path}[{n}]")
        else:
            yield path


def origin(path: str, file: Path, set_here: set[str], numbers: Mapping[str, int]) -> str:
    """Return the origin of a value: file and line, or default."""
    # A list or a table of names is set as a whole.
    named = next((one for one in set_here if path == one), "")
    if not named:
        return "default"
    while named and named not in numbers:
        named = re.sub(r"(\.[^.\[]*|\[\d+\])$", "", named) if re.search(r"[.\[]", named) else ""
    return f"{file}:{numbers[named]}" if named else str(file)


def show(config: Config, chosen: str, with_origin: bool, options: Mapping[str, object]) -> Iterator[str]:
    """Return one line for each value. `chosen`: the reason for this file; `options`: overrides of the command
    line."""
    text = config.path.read_text(encoding="utf-8")
    set_here, numbers = set(given(tomllib.loads(text))), lines_of(text)
    yield f"# {config.path} ({chosen})"
    for path, value in values(config):
        source = origin(path, config.path.relative_to(config.path.parent), set_here, numbers)
        if options.get(path):
            value, source = options[path], f"option --{path.rpartition('.')[2].replace('_', '-')}"
        elif path == "operator.name" and not value:
            value, source = operator_name(config), "default: the login name"
        shown = f"{path} = {json.dumps(value, ensure_ascii=False, default=list)}"
        yield f"{shown:<60}  # {source}" if with_origin else shown
