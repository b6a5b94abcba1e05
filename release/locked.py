"""The lock: the exact version of each package, with the hashes of its files."""

import re
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).parents[1]
LOCK = ROOT / "requirements.lock"
_PIN = re.compile(r"^([A-Za-z0-9._-]+)==(\S+)(?:[^\n]*\\\n.*--hash=\S+)*", re.MULTILINE)


def normal(name: str) -> str:
    """Return a name of a package as all tools compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def pins(text: str) -> dict[str, str]:
    """Return the lines of each package in a lock, by its name."""
    return {normal(found[1]): found[0] for found in _PIN.finditer(text)}


def versions(text: str) -> list[str]:
    """Return the packages of a lock with their versions, without hashes: pip wants no others beside them."""
    return [f"{found[1]}=={found[2]}" for found in _PIN.finditer(text)]


def constraints(to: Path) -> list[str]:
    """Return pip's arguments for the tested versions; `to` is the file that it reads."""
    to.write_text("\n".join(versions(LOCK.read_text())) + "\n")
    return ["--constraint", str(to)]


def locked(names: Iterable[str]) -> str:
    """Return the part of the lock with these packages. Raises KeyError for one that it has not."""
    known = pins(LOCK.read_text())
    return "\n".join(known[normal(name)] for name in names) + "\n"
