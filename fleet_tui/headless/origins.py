"""`fleet-tui config show`: every value in effect, and where it comes from."""

import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui.config.access import without_secrets
from fleet_tui.config.profile import FIELDS, SERVICES, TOPICS, Profile
from fleet_tui.config.schema import Config
from fleet_tui.journal.audit import operator_name
from fleet_tui.keymap import keymap

Found = tuple[str, object]

_HEADER = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?")
_KEY = re.compile(
    r"\s*((?:[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*')(?:\s*\.\s*(?:[A-Za-z0-9_-]+|\"[^\"]*\"|'[^']*'))*)\s*="
)


def values(config: Config) -> Iterator[Found]:
    """Every key that can be set, with the value in effect, unless that is secret."""
    config = without_secrets(config)
    for field in msgspec.structs.fields(Config):
        value = getattr(config, field.name)
        match field.name:
            case "path":
                continue
            case "profile":
                yield from _profile(config.profile)
            case "keys":
                chosen = keymap(config.keys)[0]
                yield from ((f"keys.{id_}", ",".join(keys)) for id_, keys in chosen.items())
            case "links":
                for name, link in value.items():
                    yield from _struct(f"links.{name}", link)
            case "floors" | "robots":
                for n, entry in enumerate(value):
                    yield from _struct(f"{field.name}[{n}]", entry)
            case _:
                yield from _struct(field.name, value)


def _struct(where: str, value: msgspec.Struct) -> Iterator[Found]:
    for name in value.__struct_fields__:
        yield f"{where}.{name}", getattr(value, name)


def _profile(profile: Profile) -> Iterator[Found]:
    for name in profile.__struct_fields__:
        match name:
            case "topics":
                yield from (
                    (f"profile.topics.{key}", profile.topic(key, "{robot}", "{floor}")) for key in TOPICS
                )
            case "types":
                yield from ((f"profile.types.{key}", profile.type(key)) for key in TOPICS)
            case "services":
                yield from ((f"profile.services.{key}", profile.service(key, "{robot}")) for key in SERVICES)
            case "service_types":
                yield from ((f"profile.service_types.{key}", profile.service_type(key)) for key in SERVICES)
            case "fields":
                usual = ((field, field.partition(".")[2]) for field in sorted(FIELDS))
                yield from ((f"profile.fields.{key}", profile.fields.get(key, name)) for key, name in usual)
            case _:
                yield f"profile.{name}", getattr(profile, name)


def lines_of(text: str) -> dict[str, int]:
    """Line number by key path, as far as a look at the lines tells."""
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
    """A dotted key without quotes and spaces."""
    parts = re.findall(r"\"[^\"]*\"|'[^']*'|[A-Za-z0-9_-]+", key)
    return ".".join(part.strip("\"'") for part in parts)


def given(table: Mapping[str, Any], where: str = "") -> Iterator[str]:
    """The key path of everything a config file sets."""
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
    """Where a value comes from: file and line, or default."""
    # A list or a table of names is set as a whole.
    named = next((one for one in set_here if path == one), "")
    if not named:
        return "default"
    while named and named not in numbers:
        named = re.sub(r"(\.[^.\[]*|\[\d+\])$", "", named) if re.search(r"[.\[]", named) else ""
    return f"{file}:{numbers[named]}" if named else str(file)


def show(config: Config, chosen: str, with_origin: bool, options: Mapping[str, object]) -> Iterator[str]:
    """One line for each value. `chosen`: why this file; `options`: what the command line says instead."""
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
