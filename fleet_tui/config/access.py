"""Secrets and certificates of a link: read from their files, and only if those are safe."""

import base64
import os
import re
import stat
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path

import msgspec

from fleet_tui.config.schema import LINK_FILES, SECRETS, Config, Link, link_key
from fleet_tui.config.trust import doubt
from fleet_tui.text.errors import ConfigError

SECRET_FILES = tuple(f"{key}_file" for key in SECRETS)
PUBLIC = ("ca_file", "client_cert")
LONGEST = 16_384  # maximum bytes of a header that servers accept
NOT_SHOWN = (*SECRET_FILES, *(f"{key}_env" for key in SECRETS), "client_key")
"""Keys of a link whose value may be secret, or a secret entered in place of a file or variable name."""
SHORTEST = 6
"""Minimum characters of a secret to mask: shorter ones occur in too many texts."""
_known: set[bytes] = set()
"""What would tell a secret that this process has read."""


def without_secrets(config: Config) -> Config:
    """Return the configuration without secrets, to be shown and passed on."""

    def public(link: Link) -> Link:
        hidden = {key: "***" for key in NOT_SHOWN if getattr(link, key)}
        return msgspec.structs.replace(link, url=link.shown, **hidden)

    links = {name: public(link) for name, link in config.links.items()}
    return msgspec.structs.replace(config, rosbridge=public(config.rosbridge), links=links)


def access_problems(config: Config) -> list[str]:
    """Return one line for each secret and certificate that can't be used. No line contains a secret."""
    problems: list[str] = []
    for name in config.bridges:
        bridge = config.bridge(name)
        looks: list[Callable[[], object]] = [
            partial(_content, bridge, key) for key in LINK_FILES if key not in SECRET_FILES
        ]
        looks += [partial(secret, bridge, key) for key in SECRETS]
        for look in looks:
            try:
                look()
            except ConfigError as problem:
                problems.append(f"{link_key(name)}.{problem}")
    return problems


def secret(bridge: Link, key: str) -> str:
    """Return the secret of a key, "" if not set. Raises ConfigError."""
    variable, where = getattr(bridge, f"{key}_env"), f"{key}_file"
    if variable:
        where, found = f"{key}_env", os.environ.get(variable, "")
        if not found:
            # Without its name: that may be the secret itself, entered by mistake.
            raise ConfigError([f"{where}: environment variable not set"])
    else:
        found = _content(bridge, where).decode("utf-8-sig", errors="replace").rstrip("\r\n")
    found = found.rstrip() if key == "authorization" else found
    if found and (len(found) > LONGEST or not re.fullmatch(r"[\x20-\x7e]+", found)):
        raise ConfigError([f"{where}: must be one line of plain ASCII"])
    if key == "authorization" and found and (problem := _of_header(found)):
        raise ConfigError([f"{where}: {problem}"])
    if key != "user":
        _known.update(word.encode() for word in _words(found) if len(word) >= SHORTEST)
    return found


def _of_header(found: str) -> str:
    """Return what is wrong with the value of a header `Authorization`, empty if nothing is."""
    if found[0] in "\"'":
        return "is in quotes: remove them"
    if re.match(r"[A-Za-z-]+\s*:", found) and " " in found:
        return "begins with the header's name: give its value alone, such as Basic ... or Bearer ..."
    return "" if " " in found else "has no scheme: begin with Basic or Bearer and a space"


def hidden(said: bytes) -> bytes:
    """Return a text, which may repeat secrets, with those masked, at the same length."""
    if not _known:  # every frame comes through here
        return said
    for word in sorted(_known, key=len, reverse=True):
        said = said.replace(word, b"*" * len(word))
    return said


def _words(secret: str) -> Iterator[str]:
    """Return the parts of a secret that tell it, those that HTTP's Basic has encoded, too."""
    for word in secret.split():
        yield word
        with suppress(ValueError):
            pair = base64.b64decode(word, validate=True).decode()
            if ":" in pair:
                yield from (pair, pair.partition(":")[2])


def _content(bridge: Link, key: str) -> bytes:
    """Return the beginning of a file named in the config. Raises ConfigError if it can't be used."""
    name = getattr(bridge, key)
    if not name:
        return b""
    try:
        # A pipe must not block.
        with os.fdopen(os.open(name, os.O_RDONLY | os.O_NONBLOCK), "rb") as opened:
            problem = unsafe(opened.fileno(), key, Path(name))
            content = b"" if problem else opened.read(LONGEST + 1)
    except (OSError, ValueError) as error:
        # Its name is not shown: it may be the secret itself, entered by mistake.
        problem = f"unreadable: {getattr(error, 'strerror', '') or 'no path'}"
    if not problem and not content:
        problem = "is empty"
    if problem:
        raise ConfigError([f"{key}: {problem}"])
    return content


def unsafe(opened: int, key: str, path: Path) -> str:
    """Return why an open file of a link can't be used, "" if it can: its mode, or who could write it."""
    return _exposure(os.fstat(opened), key not in PUBLIC) or doubt(path)


def _exposure(found: os.stat_result, is_private: bool) -> str:
    """Return the reason that a file can't be used, "" if it can."""
    if not stat.S_ISREG(found.st_mode):
        return "not a file"
    mode = stat.S_IMODE(found.st_mode)
    if is_private and mode & (stat.S_IRWXG | stat.S_IRWXO):
        return f"readable by others (mode {mode:o}): chmod 600 it"
    if is_private and found.st_uid not in (os.geteuid(), 0):
        return "owned by another user: chown it"
    return ""
