"""The doctor's judgement of each robot's services, of which none is called."""

from fleet_tui.features.doctor.causes import Cause
from fleet_tui.features.doctor.run import service_findings
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from tests.support.bridge_facts import NODE, mute, well, with_rosapi, without
from tests.support.fleets import R0
from tests.support.watched_store import config_of

WELL = well(config_of("ws://site:9090"))
PAUSE = next(name for key, name, _ in WELL.adapters[R0].services(R0) if key == "pause")


def judged(facts: BridgeFacts, *causes: Cause) -> dict[str, Finding]:
    return {one.check: one for one in service_findings(R0, facts, causes)}


def test_services_that_exist_are_well_and_name_their_node() -> None:
    found = judged(WELL)
    assert {one.verdict for one in found.values()} == {Verdict.OK}
    assert found["service pause"].measured.startswith(f"{PAUSE}, ")
    assert found["service pause"].measured.endswith(f", by {NODE}")


def test_a_service_that_is_missing_is_looked_for_under_another_name() -> None:
    services = without(WELL.rosapi.services, PAUSE)
    gone = judged(with_rosapi(WELL, services=services))["service pause"]
    assert gone.verdict is Verdict.FAIL and "correct [profile.services] pause" in gone.remedy
    near = judged(with_rosapi(WELL, services={**services, f"{PAUSE}_it": "std_srvs/Trigger"}))[
        "service pause"
    ]
    assert near.remedy.startswith(f"did you mean {PAUSE}_it?")


def test_a_service_of_another_type_or_of_none_yet() -> None:
    other = judged(with_rosapi(WELL, services={**WELL.rosapi.services, PAUSE: "x/Y"}))["service pause"]
    assert other.verdict is Verdict.FAIL and 'set [profile.service_types] pause = "x/Y"' in other.remedy
    late = judged(with_rosapi(WELL, services={**WELL.rosapi.services, PAUSE: None}))["service pause"]
    assert late.verdict is Verdict.SKIPPED and late.out_of_time


def test_what_a_cause_explains_is_folded_and_what_is_not_known_is_one_line() -> None:
    cause = Cause(Finding("", "", Verdict.FAIL, ""), "node /driver silent", services=frozenset({PAUSE}))
    folded = judged(WELL, cause)["service pause"]
    assert (folded.verdict, folded.measured) == (Verdict.SKIPPED, "node /driver silent: see above")
    assert list(judged(with_rosapi(WELL, problem="gone"))) == ["services"]
    elsewhere = mute(with_rosapi(WELL, topics={}), "")
    assert judged(elsewhere)["services"].measured == "not on this bridge: see above"
