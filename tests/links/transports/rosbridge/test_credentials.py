"""Credentials: read anew at each try, and hidden in whatever a server repeats."""

from base64 import b64encode
from pathlib import Path

import pytest

from fleet_tui.config.access import hidden
from fleet_tui.config.schema import Link
from fleet_tui.links.transports.rosbridge.connection import Credentials
from fleet_tui.text.errors import ConfigError
from tests.support.secrets import SHARED, WORD, kept


def test_they_are_read_anew_and_a_file_that_went_is_named(tmp_path: Path) -> None:
    credentials = Credentials(Link("ws://a", authorization_file=kept(tmp_path / "word", "Bearer old")))
    credentials.read()
    assert credentials.headers == {"Authorization": "Bearer old"}
    kept(tmp_path / "word", WORD)
    credentials.read()
    assert credentials.headers == {"Authorization": WORD}
    (tmp_path / "word").unlink()
    with pytest.raises(ConfigError, match="authorization_file"):
        credentials.read()


def test_what_a_server_repeats_is_hidden_at_the_same_length(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MINE", SHARED)
    credentials = Credentials(Link("ws://a", rosauth_env="MINE"))
    credentials.read()
    said = f"wrong secret {SHARED}, go away".encode()
    assert hidden(said) == said.replace(SHARED.encode(), b"*" * len(SHARED))


def test_what_basic_has_encoded_is_hidden_too(tmp_path: Path) -> None:
    word = b64encode(b"robo:Hunter2Secret").decode()
    Credentials(Link("ws://a", authorization_file=kept(tmp_path / "word", f"Basic {word}"))).read()
    for said in (word, "robo:Hunter2Secret", "Hunter2Secret"):
        assert hidden(f"no {said}!".encode()).decode() == f"no {'*' * len(said)}!"


def test_only_a_bridge_that_wants_rosauth_gets_its_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MINE", SHARED)
    for link, wants in ((Link("ws://a"), False), (Link("ws://a", rosauth_env="MINE"), True)):
        credentials = Credentials(link)
        credentials.read()
        assert bool(credentials.frame("a")) is wants and SHARED.encode() not in credentials.frame("a")
