"""Faults of a bridge or a node that silence several topics: each found once, with all that it explains."""

from dataclasses import replace
from pathlib import Path

from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.features.doctor.causes import causes_of, rosapi_finding
from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.finding import Verdict
from tests.support.bridge_facts import mute, well, with_rosapi
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 2)
WELL = well(CONFIG)
OWN = ("/queue", "/graph", "/labeled_vertices")
"""Topics of the robots' own message package."""


def test_nothing_is_the_cause_of_nothing() -> None:
    assert causes_of(CONFIG, WELL) == []


def test_types_that_all_fail_to_come_are_those_that_the_bridge_lacks() -> None:
    silent = mute(WELL, *OWN)
    (cause, *others) = causes_of(CONFIG, silent)
    assert not others and cause.short == "the bridge lacks OH_ressources"
    assert cause.topics == {one.topic for one in WELL.topics if one.topic.endswith(OWN)}
    assert cause.finding.remedy == "source the workspace with OH_ressources, then restart rosbridge"


def test_a_node_that_is_silent_on_all_its_topics_explains_them_and_its_services() -> None:
    of_node = {one.topic: ("/sensors",) for one in WELL.topics if one.topic.endswith(("cargo", "battery"))}
    facts = with_rosapi(
        WELL, publishers={**WELL.rosapi.publishers, **of_node}, owners={"/calibrate": "/sensors"}
    )
    (cause,) = causes_of(CONFIG, mute(facts, "cargo", "battery"))
    assert cause.finding.measured.startswith("/sensors silent: no messages in 5.0 s on the 4 topics")
    assert cause.topics == set(of_node) and cause.services == {"/calibrate"}
    assert cause.finding.subject == WELL.name, "it is a node of both robots"
    assert causes_of(CONFIG, mute(facts, "robot_0/battery")) == [], "a single topic is listed as one"


def test_topics_without_any_service_are_nodes_that_the_master_forgot() -> None:
    (cause,) = causes_of(CONFIG, with_rosapi(WELL, services={"/rosapi/topics": None}))
    assert (
        cause.finding.verdict is Verdict.FAIL
        and "(topics of robot_0, robot_1 arrive" in cause.finding.measured
    )
    assert cause.services == set(WELL.rosapi.services)
    other_names = {f"/{robot.name}/other": None for robot in CONFIG.robots}
    assert causes_of(CONFIG, with_rosapi(WELL, services=other_names)) == []


def test_an_action_whose_goal_the_bridge_has_just_dropped_is_one_that_its_list_lacks(tmp_path: Path) -> None:
    config = demo_config(Config(), "ws://site:9090", 2, 1, "2", "nav2", tmp_path)
    adapters = adapters_of(config)
    facts = replace(WELL, adapters=adapters, barred=frozenset({"/robot_0/navigate_to_pose", "/other/action"}))
    (cause,) = [one for one in causes_of(config, facts) if one.finding.check == "actions_glob"]
    assert cause.finding.measured == "the bridge does not allow /robot_0/navigate_to_pose"
    assert "to actions_glob of rosbridge" in cause.finding.remedy


def test_a_rosapi_that_is_not_there_is_no_failure_but_a_broken_one_is() -> None:
    assert rosapi_finding(WELL).verdict is Verdict.OK
    for problem, verdict in (
        ("service /rosapi/topics does not exist", Verdict.WARN),
        ("crashed", Verdict.FAIL),
    ):
        found = rosapi_finding(with_rosapi(WELL, problem=problem))
        assert found.verdict is verdict and found.measured.startswith(problem)
    assert RosapiFacts(problem="Unable to communicate with service").is_silent
