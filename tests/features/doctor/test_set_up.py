"""The other end of set-up, as rosapi has it: who listens, who offers a service, and what to do about it."""

from dataclasses import replace
from typing import Any

import pytest
from msgspec.structs import replace as altered

from fleet_tui.features.doctor.probing import probe_findings
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.robots.adapter import Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS
from tests.support.bridge_facts import well, with_rosapi
from tests.support.fleets import R0
from tests.support.watched_store import config_of

POSE, POSE_TYPE = f"/{R0}/initialpose", "geometry_msgs/PoseWithCovarianceStamped"
SETTLE = f"/{R0}/settle"
NAMED = Profile(
    topics={"initial_pose": "/{robot}/initialpose"},
    services={"settle": "/{robot}/settle", **dict.fromkeys(("mapping_on", "mapping_off"), "/{robot}/map")},
)
ASKED = {POSE: ("/amcl", "/rosbridge_websocket")}
OFFERED = {SETTLE: "std_srvs/Empty", f"/{R0}/map": "std_srvs/SetBool"}


def site(**rosapi: Any) -> BridgeFacts:
    """A bridge on which all is well, but for some answers of rosapi."""
    facts = well(altered(config_of("ws://site:9090"), profile=NAMED))
    known = facts.rosapi
    changes = {
        "topics": {**known.topics, POSE: POSE_TYPE},
        "services": {**known.services, **OFFERED},
        "subscribers": ASKED,
        "owners": {**known.owners, SETTLE: "/amcl"},
    }
    return with_rosapi(facts, **(changes | rosapi))


def found(facts: BridgeFacts) -> dict[str, Finding]:
    return {finding.check: finding for finding in probe_findings(R0, facts)}


def test_what_has_another_end_is_well() -> None:
    findings = found(site())
    assert list(findings) == ["initial_pose", "service settle", "service mapping_on, mapping_off"]
    assert {finding.verdict for finding in findings.values()} == {Verdict.OK}
    assert findings["initial_pose"].measured == f"/amcl listens on {POSE}, {POSE_TYPE}"
    assert findings["service settle"].measured == f"{SETTLE}, std_srvs/Empty, by /amcl"


@pytest.mark.parametrize("nodes", [(), ("/rosbridge_websocket",)])
def test_where_nobody_but_the_bridge_listens_it_is_said(nodes: tuple[str, ...]) -> None:
    finding = found(site(subscribers={POSE: nodes}))["initial_pose"]
    assert (finding.verdict, finding.measured) == (
        Verdict.WARN,
        f"nobody listens on {POSE}: no setting of the pose",
    )
    assert finding.remedy.endswith('or set [profile.topics] initial_pose = "" if not used')


def test_a_similar_name_is_proposed() -> None:
    topics = {**site().rosapi.topics, f"/{R0}/initial_pose": POSE_TYPE}
    finding = found(site(subscribers={POSE: ()}, topics=topics))["initial_pose"]
    assert finding.remedy.startswith(f"did you mean /{R0}/initial_pose? ")


def test_another_type_is_named() -> None:
    topics = {**site().rosapi.topics, POSE: "geometry_msgs/Pose"}
    finding = found(site(topics=topics))["initial_pose"]
    assert (
        finding.verdict is Verdict.WARN
        and f"has type geometry_msgs/Pose, not {POSE_TYPE}" in finding.measured
    )
    services = {**site().rosapi.services, SETTLE: "std_srvs/Trigger"}
    finding = found(site(services=services))["service settle"]
    assert (
        finding.verdict is Verdict.WARN
        and "not std_srvs/Empty: no refinement of the pose" in finding.measured
    )
    assert "[profile.service_types] settle" in finding.remedy


def test_a_service_that_is_not_there_costs_its_action_only() -> None:
    services = {name: type_ for name, type_ in site().rosapi.services.items() if name not in OFFERED}
    findings = found(site(services=services))
    assert findings["service settle"].measured == f"{SETTLE} is not on the bridge: no refinement of the pose"
    switch = findings["service mapping_on, mapping_off"]
    assert 'mapping_on = "", mapping_off = "" if not used' in switch.remedy
    assert not any(finding.is_failure for finding in findings.values())


def test_what_could_not_be_asked_is_not_judged() -> None:
    services = {**site().rosapi.services, SETTLE: None}
    findings = found(site(subscribers={}, services=services))
    for check in ("initial_pose", "service settle"):
        assert findings[check].verdict is Verdict.SKIPPED and findings[check].out_of_time
    assert found(site(problem="no reply")) == {}


def test_a_kind_without_the_names_has_nothing_to_check() -> None:
    facts = site()
    bare = KINDS["oh_ressources"].adapter(Profile(), Site())
    assert found(replace(facts, adapters={R0: bare})) == {}


@pytest.mark.parametrize(
    ("map_saver", "verdict"), [("/map_saver/save_map", Verdict.SKIPPED), ("/saver/save", Verdict.WARN)]
)
def test_a_usual_name_without_a_namespace_was_chosen_by_nobody(map_saver: str, verdict: Verdict) -> None:
    profile = Profile(
        kind="nav2", topics={"initial_pose": "/initialpose"}, services={"map_save": map_saver}
    )  # as `config init` writes them all
    facts = well(altered(config_of("ws://site:9090"), profile=profile))
    findings = found(with_rosapi(facts, subscribers={"/initialpose": ()}))
    assert findings["service map_save"].verdict is verdict
    assert findings["initial_pose"].verdict is Verdict.SKIPPED
