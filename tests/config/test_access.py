"""Secrets come from safe places, and what does not is named without being repeated."""

import os
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.access import access_problems, secret
from fleet_tui.config.check import checked
from fleet_tui.config.load import load
from fleet_tui.config.schema import Link
from fleet_tui.text.errors import ConfigError
from tests.support.secrets import SHARED, WORD, bridged, kept
from tests.support.watched_store import config_of


@pytest.mark.parametrize(
    ("text", "mode", "words"),
    [
        (WORD, 0o640, "rosbridge.authorization_file: readable by others (mode 640): chmod 600 it"),
        (WORD, 0o604, "rosbridge.authorization_file: readable by others (mode 604): chmod 600 it"),
        ("", 0o600, "rosbridge.authorization_file: is empty"),
        (f'"{WORD}"', 0o600, "rosbridge.authorization_file: is in quotes: remove them"),
        (
            f"Authorization: {WORD}",
            0o600,
            "rosbridge.authorization_file: begins with the header's name: give its value alone, such as"
            " Basic ... or Bearer ...",
        ),
        (
            "dXNlcg==",
            0o600,
            "rosbridge.authorization_file: has no scheme: begin with Basic or Bearer and a space",
        ),
        (f"{WORD}\nX: y", 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
        (f"{WORD}\xe9", 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
        ("x" * 20_000, 0o600, "rosbridge.authorization_file: must be one line of plain ASCII"),
    ],
)
def test_a_file_that_is_not_taken(tmp_path: Path, text: str, mode: int, words: str) -> None:
    link = Link(authorization_file=kept(tmp_path / "a", text, mode))
    assert access_problems(bridged(link)) == [words]


def test_a_file_that_is_taken(tmp_path: Path) -> None:
    link = Link(authorization_file=kept(tmp_path / "a", WORD + "\n"))
    assert access_problems(bridged(link)) == []
    assert secret(link, "authorization") == WORD
    os.mkfifo(tmp_path / "pipe", 0o600)
    for name, words in (("gone", "No such file"), ("pipe", "not a file"), ("a\0b", "no path")):
        (line,) = access_problems(bridged(Link(rosauth_file=str(tmp_path / name))))
        assert line.startswith("rosbridge.rosauth_file: ") and words in line


def test_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FLEET_WORD", WORD)
    assert secret(Link(authorization_env="FLEET_WORD"), "authorization") == WORD
    # Somebody may put the secret itself where the variable's name belongs.
    with pytest.raises(ConfigError) as caught:
        secret(Link(authorization_env=SHARED), "authorization")
    assert SHARED not in str(caught.value) and "authorization_env" in str(caught.value)


@pytest.mark.parametrize(
    ("link", "words"),
    [
        (Link("ws://ana:hush@a:1"), "url: user and password not allowed"),
        (Link("http://ana:hush@a:1/?token=hush"), "url: 'http://***@a:1/?***' is not an address"),
        (Link("ana:hu/sh@a:1"), "url: '***@a:1' is not an address"),
        (Link("ws://a", ca_file="x"), "ca_file: ws:// has no TLS"),
        (Link("wss://a", client_key="x"), "client_key: needs client_cert"),
        (Link("ws://a", rosauth_env="A", rosauth_file="b"), "rosauth_file: use rosauth_file or rosauth_env"),
    ],
)
def test_what_does_not_go_together(link: Link, words: str) -> None:
    for where, config in (
        ("rosbridge", bridged(link)),
        ("links.b", replace(config_of("ws://a"), links={"b": link})),
    ):
        (line,) = checked(config)
        assert line.startswith(f"{where}.{words}") and "hush" not in line


def test_files_of_a_link_lie_beside_the_config(tmp_path: Path) -> None:
    kept(tmp_path / "word", WORD)
    (tmp_path / "config.toml").write_text(
        '[links.b]\nurl = "wss://a"\nauthorization_file = "word"\nmax_message_mb = 7\n'
        '[[floors]]\nname = "f"\n[[robots]]\nname = "r"\nlink = "b"\n'
    )
    config = load(tmp_path / "config.toml")
    assert access_problems(config) == []
    assert secret(config.bridge("b"), "authorization") == WORD
    assert config.bridge("b").max_message_mb == 7
