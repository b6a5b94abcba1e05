"""Finds, reads and checks a configuration: every problem at once, each with its remedy."""

import os
import re
import tomllib
import typing
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from types import UnionType
from typing import Any, Literal

import msgspec
import platformdirs

from fleet_tui.config.check import EMPTY, checked
from fleet_tui.config.schema import NOT_IN_FILE, Config, expanded
from fleet_tui.config.small_file import LARGEST, read_text, toml
from fleet_tui.config.withholding import safe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS
from fleet_tui.text.errors import ConfigError, NoConfigError, did_you_mean

_WORDS = {"str": "text", "int": "a whole number", "float": "a number", "bool": "true or false"} | {
    "array": "a list",
    "object": "a table",
    "null": "nothing",
}


def shipped() -> Path:
    """Return the example shipped with the program: package data in a wheel, else beside the checkout."""
    package = Path(__file__).parent.parent
    inside = package / "config_shipped.toml"
    return inside if inside.exists() else package.parent / "config.toml"


def user_folder() -> Path:
    """Return the folder of the user's config and themes."""
    return platformdirs.user_config_path("fleet-tui")


def places() -> list[Path]:
    """Return the search paths of an unnamed configuration."""
    return [Path("config.toml"), user_folder() / "config.toml"]


def find(given: str | None) -> Path:
    """Return the path of the config: given, $FLEET_TUI_CONFIG, ./config.toml, the user's. Raises
    ConfigError, NoConfigError if none is named."""
    if given:
        return expanded(given)
    if named := os.environ.get("FLEET_TUI_CONFIG"):
        return _there(expanded(named))
    found = next((place for place in places() if place.is_file()), None)
    if found is None:
        raise NoConfigError(
            [
                f"no configuration found: $FLEET_TUI_CONFIG is not set, no ./{places()[0]}, no {places()[1]}",
                "use --config FILE, or --url ws://HOST:9090 for a bridge; fleet-tui"
                " config init prints an example, fleet-tui demo needs no configuration",
            ]
        )
    return found


def _there(path: Path) -> Path:
    """Return the path of the variable. Raises ConfigError without such a file: nobody typed that name now."""
    with suppress(PermissionError):  # told when it is read
        if not path.exists():
            raise ConfigError([f"$FLEET_TUI_CONFIG names {path}: no such file"])
    return path


def looked_for() -> list[tuple[str, str]]:
    """Return each searched path, and its state."""
    variable = os.environ.get("FLEET_TUI_CONFIG")
    here, users = places()
    named = {"$FLEET_TUI_CONFIG": variable or "not set"}
    for name, place in ((f"./{here}", here), (str(users).replace(str(Path.home()), "~", 1), users)):
        named[name] = "there" if place.is_file() else "not there"
    return list(named.items())


def load_if_any(given: str | None) -> Config:
    """Read the config, or return an empty one: for a console with robots and floors from elsewhere. Raises
    ConfigError."""
    try:
        path = find(given)
    except NoConfigError:
        return Config()
    return load(path, needs_robots=False)


def load(path: Path, needs_robots: bool = True) -> Config:
    """Read and check a file. Raises ConfigError with every problem found; that there is no robot or no floor
    is one if it `needs_robots`."""
    config, problems = read(path)
    if problems := [line for line in problems if needs_robots or EMPTY not in line]:
        raise ConfigError([f"{path}: {line}" for line in problems])
    return config


def read(path: Path) -> tuple[Config, list[str]]:
    """Parse a file as far as possible, without what must come from a safe one, and return its problems.
    Raises ConfigError for invalid TOML."""
    text = ""
    try:
        text = read_text(path, LARGEST)
        table = toml(text)
    except FileNotFoundError:
        made = f"fleet-tui config init --output {path} writes one"
        raise ConfigError([f"{path}: no such file: {made}"]) from None
    except OSError as problem:
        raise ConfigError([f"{path}: unreadable: {problem.strerror}"]) from None
    except UnicodeDecodeError:
        raise ConfigError([f"{path}: not UTF-8 text: save it as UTF-8"]) from None
    except (ValueError, RecursionError) as problem:
        raise ConfigError([f"{path}: not TOML: {problem}{_habit(text, str(problem))}"]) from None
    config, problems = _config_of(table)
    return safe(msgspec.structs.replace(config, path=path.absolute()), text), problems


def _habit(text: str, problem: str) -> str:
    """Return what of another program or format is where a text is no TOML, empty if nothing is."""
    place = re.search(r"at line (\d+), column (\d+)", problem)
    lines = text.splitlines()
    if place is not None and int(place[1]) <= len(lines):
        found = lines[int(place[1]) - 1][int(place[2]) - 1 :][:1]
        if found and found in "“”„‘’":
            return "; this is the quote of a text processor: write a straight one"
        if found == "\u00a0":
            return "; this is a no-break space: write a usual one"
    used = [line for line in map(str.strip, lines) if line and not line.startswith(("#", "---"))]
    if used and used[0].startswith(("{", "[{")):
        return "; this is JSON: write key = value below [table]"
    if used and re.match(r"[\w-]+:(\s|$)", used[0]):
        return "; this is YAML: write key = value below [table]"
    return ""


def from_text(text: str) -> Config:
    """Read and check a configuration without a file. Raises ConfigError with every problem found."""
    try:
        config, problems = _config_of(tomllib.loads(text))
    except (ValueError, RecursionError) as problem:
        raise ConfigError([f"not TOML: {problem}"]) from None
    if problems:
        raise ConfigError(problems)
    return config


def _config_of(table: Mapping[str, object]) -> tuple[Config, list[str]]:
    problems: list[str] = []
    config: Config = _read(Config, table, "", problems) or Config()
    problems += [f"{name}: unknown key" for name in NOT_IN_FILE if name in table]
    return config, problems + checked(config)


def _read(struct: type[Any], table: object, where: str, problems: list[str]) -> Any | None:
    """Return `table` as `struct`; errors go to `problems`, key by key, and the default is used."""
    if not isinstance(table, Mapping):
        problems.append(f"{where.rstrip('.')}: must be a table")
        return None
    fields = {field.name: field for field in msgspec.structs.fields(struct)}
    problems.extend(
        f"{where}{key}: unknown key{did_you_mean(key, fields)}" for key in table if key not in fields
    )
    values: dict[str, Any] = {}
    for name, field in fields.items():
        if name in table and not (struct is Config and name in NOT_IN_FILE):
            value = _read_value(field.type, table[name], where + name, problems)
            if value is not None:
                values[name] = value
        elif field.required:
            problems.append(f"{where}{name}: missing")
    # Every required field is a name. The entry gets a unique one, so that the
    # entries after it keep their numbers.
    placeholder = "".join(letter if letter.isalnum() else "_" for letter in where)
    missing = {name: placeholder for name, field in fields.items() if field.required and name not in values}
    return struct(**missing, **values)


def _without_none(kind: Any) -> Any:
    """Drop the None from a union: TOML has no null, so only the other type can be in a file."""
    if typing.get_origin(kind) in (UnionType, typing.Union):  # the latter is that of Annotated
        return next(one for one in typing.get_args(kind) if one is not type(None))
    return kind


def _is_struct(kind: object) -> bool:
    return isinstance(kind, type) and issubclass(kind, msgspec.Struct)


def _read_value(kind: Any, value: Any, where: str, problems: list[str]) -> Any | None:
    kind = _without_none(kind)
    origin, inner = typing.get_origin(kind), typing.get_args(kind)
    if kind is Profile and isinstance(value, Mapping):
        value = _with_settings(value)
    if _is_struct(kind):
        return _read(kind, value, where + ".", problems)
    if origin is list and _is_struct(inner[0]) and isinstance(value, list):
        rows = (_read(inner[0], entry, f"{where}[{n}].", problems) for n, entry in enumerate(value))
        return [row for row in rows if row is not None]
    if origin is dict and isinstance(value, Mapping):
        entries = [
            (key, _read_value(inner[1], entry, f"{where}.{key}", problems)) for key, entry in value.items()
        ]
        return {key: entry for key, entry in entries if entry is not None}
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError as problem:
        problems.append(f"{where}: {_as_message(kind, value, str(problem))}")
        return None


def _with_settings(table: Mapping[str, object]) -> dict[str, object]:
    """Merge the tables of single kinds: only their adapters know their keys."""
    own = {key: value for key, value in table.items() if key in KINDS}
    rest = {key: value for key, value in table.items() if key not in KINDS}
    return {**rest, "settings": own} if own else rest


def _as_message(kind: Any, value: object, problem: str) -> str:
    """Return msgspec's message in plain words."""
    if typing.get_origin(kind) is Literal and isinstance(value, str):
        choices = typing.get_args(kind)
        return f"{value!r} is not one of {', '.join(choices)}{did_you_mean(value, choices)}"
    for name, message in _WORDS.items():
        problem = problem.replace(f"`{name}`", message)
    return problem[0].lower() + problem[1:]
