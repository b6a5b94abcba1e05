"""Rights: the file in which the administrator of a machine says who may command from it.

The names are those of the Unix user and groups that the process really has: no variable of the environment
and no configuration takes part.
"""

import grp
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.config.small_file import read_toml
from fleet_tui.config.trust import ROOT, doubt, user_name
from fleet_tui.model.problem import Permissions, Right
from fleet_tui.text.errors import did_you_mean

FILE = Path("/etc/fleet-tui/rights.toml")
OWNER = ROOT
TABLES = {right.word: right for right in Right}
KEYS = ("users", "groups")


class RightsError(ValueError):
    """A file of rights that can't be trusted, or read."""


def own_rights(file: Path | None = None) -> Permissions:
    """Return what the user of this process may do: everything without the file; with one that is wrong,
    nothing but to view, with the reason."""
    path = file or FILE
    try:
        table = _trusted(path)
    except FileNotFoundError:
        # A link to nowhere was meant to be a file of rights.
        lost = f"{path}: it leads to a file that does not exist"
        return Permissions(right=Right.VIEW, why=lost) if path.is_symlink() else Permissions()
    except (OSError, ValueError, RecursionError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        return Permissions(right=Right.VIEW, why=f"{path}: {reason}")
    users, groups = {own_user()}, set(own_groups())
    found = [
        right
        for word, right in TABLES.items()
        if users & set(table.get(word, {}).get("users", ()))
        or groups & set(table.get(word, {}).get("groups", ()))
    ]
    return Permissions(right=max(found, default=Right.VIEW))


def own_user() -> str:
    """Return the name of the real user of this process, its number if it has none."""
    return user_name(os.getuid())


def own_groups() -> list[str]:
    """Return the names of the real groups of this process."""
    names = []
    for number in dict.fromkeys([os.getgid(), *os.getgroups()]):
        with suppress(KeyError):
            names.append(grp.getgrgid(number).gr_name)
    return names


def permissions_of(config: Config) -> Permissions:
    """Return the permissions of a console: the user's rights, and what its configuration leaves of them."""
    rights = own_rights()
    return Permissions(config.operator.read_only, config.operator.armed, rights.right, rights.why)


def _trusted(path: Path) -> Mapping[str, Mapping[str, list[str]]]:
    """Return the tables of the file. Raises OSError, or ValueError if somebody else than root may have
    written it, or it is wrong."""
    path.stat()
    if found := doubt(path, OWNER):
        raise RightsError(found)
    table = read_toml(path)
    for word, entries in table.items():
        if word not in TABLES:
            raise RightsError(f"unknown table [{word}]{did_you_mean(word, TABLES)}")
        if not isinstance(entries, dict):
            raise RightsError(f"[{word}] must be a table")
        for key, names in entries.items():
            if key not in KEYS:
                raise RightsError(f"unknown key {word}.{key}{did_you_mean(key, KEYS)}")
            if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
                raise RightsError(f"{word}.{key} must be a list of names")
    return table
