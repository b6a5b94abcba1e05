"""A configuration that was written reads as itself, and holds no secret where it must not."""

import tomllib
from pathlib import Path

import msgspec
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.access import without_secrets
from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.load import read
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.saving import as_toml
from fleet_tui.config.schema import Alarms, Config, Link, Operator
from fleet_tui.robots.profile import Profile

TEXT = st.text(st.characters(exclude_categories=["Cs"]))


def test_a_written_configuration_reads_as_itself(tmp_path: Path) -> None:
    config = Config(
        rosbridge=Link("ws://127.0.0.1:9090", max_message_mb=0.5),
        links={"site b".replace(" ", "_"): Link("wss://host:1/path")},
        floors=[FloorEntry("floor_0", "maps/a b.yaml"), FloorEntry("floor_1", frame_id="map_1")],
        robots=[RobotEntry("robot_0", ["floor_0"], size=(0.9, 0.6)), RobotEntry("robot_1", link="site_b")],
        operator=Operator('Ana "the \\ boss"', armed=False),
        keys={"quit": "ctrl+q"},
        alarms=Alarms(bell=["high"], offline_after=7.5),
        programs=[ProgramEntry("p", start=["a b", '"c'], needs=["q"]), ProgramEntry("q", unit="q.service")],
        profile=Profile(topics={"pose": "/{robot}/pose"}, refusals=(r"(?i)\bno\b",), directed=True),
        profiles={"cart": Profile(kind="nav2", topics={"drive": ""})},
    )
    path = tmp_path / "config.toml"
    path.write_text(as_toml(config))
    found, problems = read(path)
    assert problems == []
    assert msgspec.structs.replace(found, path=config.path) == config


@given(TEXT, TEXT, st.lists(TEXT))
def test_any_text_survives(name: str, key: str, words: list[str]) -> None:
    config = Config(operator=Operator(name), keys={key: name}, profile=Profile(refusals=tuple(words)))
    table = tomllib.loads(as_toml(config))
    assert table["operator"]["name"] == name
    assert table["keys"] == {key: name}
    assert table["profile"]["refusals"] == words


def test_what_is_handed_on_has_no_secret() -> None:
    link = Link("ws://ana:SECRET@host:1/?token=SECRET", authorization_env="SECRET", client_key="SECRET")
    config = Config(rosbridge=link, links={"b": link}, robots=[RobotEntry("r", link="b")])
    assert "SECRET" in as_toml(config)
    assert "SECRET" not in as_toml(without_secrets(config))
    assert without_secrets(config).rosbridge.ca_file == ""
