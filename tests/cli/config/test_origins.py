"""`fleet-tui config show --origin`: what is in effect, and who said so."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.cli.config.origins import lines_of, values
from fleet_tui.config.schema import Config, Link
from tests.support.cli import run

TEXT = """\
[rosbridge]
url = "wss://host:9090?token=secret"
ca_file = "ca.pem"
authorization_file = "key.txt"

[[floors]]
name = "floor_0"

[[robots]]
name = "robot_0"
floors = [
  "floor_0",
]
[[robots]]
name = "robot_1"

[links.b]
url = "ws://b:9090"

[ui]
theme = "light"
pose_ms = 100

[keys]
order = "ctrl+o"

[profile]
topics.pose = "/{robot}/amcl_pose"
[profile.fields]
"queue.orders" = "tasks"
"""


@pytest.fixture
async def shown(tmp_path: Path) -> dict[str, str]:
    """The shown configuration, as path -> the rest of its line."""
    (tmp_path / "config.toml").write_text(TEXT)
    done = await run(tmp_path, "config", "show", "--origin", "--drawing", "ascii")
    assert (done.code, done.err) == (0, "")
    first, *lines = done.out.splitlines()
    assert first == f"# {tmp_path / 'config.toml'} (in this folder)"
    return {path: " ".join(rest.split()) for path, _, rest in (line.partition(" = ") for line in lines)}


async def test_each_value_and_where_it_comes_from(shown: dict[str, str]) -> None:
    assert shown["robots[1].name"] == '"robot_1" # config.toml:15'
    assert shown["robots[0].floors"] == '["floor_0"] # config.toml:11'
    assert shown["links.b.url"] == '"ws://b:9090" # config.toml:18'
    assert shown["ui.theme"] == '"light" # config.toml:21'
    assert shown["ui.pose_ms"] == "100 # config.toml:22"
    assert shown["keys.order"] == '"ctrl+o" # config.toml:25'
    assert shown["profile.topics.pose"] == '"/{robot}/amcl_pose" # config.toml:28'
    assert shown["profile.fields.queue.orders"] == '"tasks" # config.toml:30'
    assert shown["ui.drawing"] == '"ascii" # option --drawing'
    assert shown["alarms.offline_after"] == "5.0 # default"
    assert shown["profile.topics.queue"] == '"/{robot}/queue" # default'
    assert shown["operator.name"].endswith("# default: the login name")


async def test_no_secret_is_shown(shown: dict[str, str]) -> None:
    assert shown["rosbridge.url"] == '"wss://host:9090?***" # config.toml:2'
    assert shown["rosbridge.authorization_file"] == '"***" # config.toml:4'
    assert shown["rosbridge.ca_file"] == '"ca.pem" # config.toml:3'
    assert "token" not in str(shown) and "key.txt" not in str(shown)


def test_every_key_of_the_config_is_shown_once() -> None:
    paths = [path for path, _ in values(Config(links={"b": Link()}))]
    assert len(paths) == len(set(paths))
    assert {path.partition(".")[0] for path in paths} >= {"rosbridge", "operator", "ui", "alarms", "profile"}


@given(st.text())
def test_any_text_has_lines(text: str) -> None:
    lines = text.splitlines()
    for path, number in lines_of(text).items():
        assert path.rpartition(".")[2].partition("[")[0] in lines[number - 1]
