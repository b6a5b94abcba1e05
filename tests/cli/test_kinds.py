"""Kinds of robots without a screen: what they are, and what is answered where one lacks something."""

import asyncio
import json
from pathlib import Path

import msgspec
import pytest

from fleet_tui.cli.orders.giving import command, how, pause
from fleet_tui.cli.status.status import status
from fleet_tui.config.schema import Config
from fleet_tui.features.doctor.run import doctor
from fleet_tui.robots.registry import DEFAULT_KIND, KINDS
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import asked, run
from tests.support.made_up_kind import mixed


@pytest.fixture
def config(server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Config:
    """robot_1 has no cargo, and can't be paused."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr("fleet_tui.cli.orders.giving.ENDING", ())  # signals are for main threads
    return mixed(monkeypatch, server.url, 1)


async def given(config: Config, *words: str) -> tuple[int, list[str]]:
    said = list[str]()

    def say(line: str, err: bool = False) -> None:
        said.append(line)

    if words[0] == "pause":
        code = await asyncio.to_thread(pause, config, words[1], how(config, 10.0, False), False, say)
    else:
        code = await asyncio.to_thread(command, config, words, how(config, 10.0, False), False, say)
    return code, said


async def test_every_kind_is_listed(tmp_path: Path) -> None:
    plain, as_json = await run(tmp_path, "kinds"), await run(tmp_path, "kinds", "--json")
    assert (plain.code, as_json.code, plain.err) == (0, 0, "")
    found = json.loads(as_json.out)
    assert found["version"] == 1
    assert [one["name"] for one in found["kinds"]] == list(KINDS)
    (usual,) = [one for one in found["kinds"] if one["default"]]
    assert usual["name"] == DEFAULT_KIND and "paused" in usual["can_report"]
    assert {"order", "order to", "cancel", "clear", "pause", "resume"} == set(usual["accepts"])
    for one in found["kinds"]:
        assert one["name"] in plain.out and set(one["silence_s"]) <= set(one["reports"])


async def test_the_docs_have_the_same_table(tmp_path: Path) -> None:
    docs = (Path(__file__).parents[2] / "docs" / "kinds.md").read_text()
    said = (await run(tmp_path, "kinds")).out
    assert f"```text\n{said}```\n" in docs


@pytest.mark.parametrize("words", [("clear", "robot_1"), ("resume", "robot_1"), ("pause", "robot_1")])
async def test_what_a_kind_lacks_is_1_and_nothing_leaves(
    config: Config, server: RosbridgeServer, words: tuple[str, str]
) -> None:
    code, (line,) = await given(config, *words)
    assert code == 1 and "not sent" in line and f"this kind has no {words[0]})" in line
    assert not server.bridge.services.calls


@pytest.mark.parametrize("verb", ["pause", "resume"])
async def test_all_means_those_that_can_and_the_others_are_named(
    config: Config, server: RosbridgeServer, verb: str
) -> None:
    code, lines = await given(config, verb, "all")
    assert code == 1 and asked(server) == [f"robot_0 {verb.capitalize()}"]
    assert f"robot_1 {verb}: not sent (this kind has no {verb})" in lines
    assert any(line.startswith(f"robot_0 {verb}: confirmed") for line in lines)


async def test_an_order_to_one_place_waits_for_no_cargo(config: Config, server: RosbridgeServer) -> None:
    server.world.robots["robot_1"].cargo = True  # as the simulator has it: it serves only such orders
    code, (line,) = await given(config, "order", "robot_1", "Consumidores")
    assert (code, line.startswith("robot_1 go to Consumidores: confirmed")) == (0, True), line


async def test_status_and_doctor_expect_only_what_is_reported(
    config: Config, server: RosbridgeServer
) -> None:
    said = list[str]()
    assert await asyncio.to_thread(status, config, 5.0, True, False, False, said.append) == 0
    robots = json.loads(said[0])["robots"]
    assert "cargo" in robots[0] and {"cargo", "obstacle_s", "paused"}.isdisjoint(robots[1])
    assert robots[1]["never_came"] == []
    lines = list[str]()
    await asyncio.to_thread(doctor, config, 15.0, False, lines.append)
    assert any("robot_0 cargo" in line for line in lines)
    assert not any("robot_1 cargo" in line or "robot_1 obstacle" in line for line in lines)


async def test_doctor_measures_a_value_by_the_silence_of_its_kind(
    config: Config, server: RosbridgeServer
) -> None:
    profile = msgspec.structs.replace(config.profile, silence={"battery": 0.05})
    lines = list[str]()
    strict = msgspec.structs.replace(config, profile=profile)
    await asyncio.to_thread(doctor, strict, 15.0, False, lines.append, "robot_0")
    (battery,) = [line for line in lines if "robot_0 battery:" in line]
    assert "counts as old after 0.05 s" in battery
    assert any("raise profile.silence.battery" in line for line in lines)
