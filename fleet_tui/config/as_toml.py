"""A configuration as a file: the effective values, to be passed on."""

import json
from collections.abc import Mapping

import msgspec

from fleet_tui.config.schema import NOT_IN_FILE, Config


def _value(value: object) -> str:
    """Return a value on one line. JSON's strings, numbers and lists are valid TOML."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(_lines(value)) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_value, value)) + "]"
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: str) -> str:
    return _value(name)


def _lines(table: Mapping[str, object]) -> list[str]:
    return [f"{_key(key)} = {_value(value)}" for key, value in table.items() if value is not None]


def as_toml(config: Config) -> str:
    """Return the text of a file that parses to this configuration."""
    text = []
    for name, part in msgspec.to_builtins(config, enc_hook=str).items():
        if name in NOT_IN_FILE:
            continue
        head, tables = (f"[[{name}]]", part) if isinstance(part, list) else (f"[{name}]", [part])
        for table in tables:
            text += [head, *_lines(table), ""]
    return "\n".join(text)
