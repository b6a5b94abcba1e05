"""Secrets of a link, kept as they must be."""

from pathlib import Path

from msgspec.structs import replace

from fleet_tui.config.schema import Config, Link
from tests.support.watched_store import config_of

WORD = "Bearer s3same-0pen"


SHARED = "0123456789abcdef"


def kept(path: Path, text: str, mode: int = 0o600) -> str:
    """A file with a secret in it."""
    path.write_text(text)
    path.chmod(mode)
    return str(path)


def bridged(link: Link) -> Config:
    return replace(config_of(link.url, 1), rosbridge=link)
