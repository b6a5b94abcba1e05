"""Credentials for a bridge, which appear in no message."""

import platform
import secrets
import time

from fleet_tui.config.access import secret
from fleet_tui.config.schema import Link
from fleet_tui.transports.rosbridge.rosauth import auth

SHORTEST = 6
"""Characters of a word that is looked for: a shorter one stands in too much else."""


class Credentials:
    """The secrets of one link, as they were at the last try."""

    def __init__(self, bridge: Link) -> None:
        self._bridge = bridge
        self._rosauth = ""
        self.headers: dict[str, str] = {}
        self._told: list[bytes] = []

    def read(self) -> None:
        """Read them anew: they may have been renewed. Raises ConfigError."""
        authorization = secret(self._bridge, "authorization")
        self.headers = {"Authorization": authorization} if authorization else {}
        self._rosauth = secret(self._bridge, "rosauth")
        words = [*authorization.split(), self._rosauth]
        self._told = [word.encode() for word in words if len(word) >= SHORTEST]

    def frame(self, host: str) -> bytes:
        """The first frame of a connection, empty where the bridge wants none."""
        if not self._rosauth:
            return b""
        rand, now = secrets.token_hex(16), int(time.time())
        return auth(self._rosauth, platform.node(), host, rand, now)

    def hidden(self, said: bytes) -> bytes:
        """Return what a server says, which may repeat what it was told, at the same length."""
        for word in self._told:
            said = said.replace(word, b"*" * len(word))
        return said
