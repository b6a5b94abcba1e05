"""Any JSON on any topic in any order: nothing raises, all that is shown is harmless."""

from typing import Any

import msgspec
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.robots.vda5050.topics import READ
from fleet_tui.situation.why.why import reasons
from fleet_tui.ui.view.robot.sections import factsheet_rows, vehicle_rows
from fleet_tui.ui.view.tables.news import news
from tests.support.hostile_text import harmless
from tests.support.vda_fleet import VehicleSite
from tests.support.vda_messages import BASE

TEXTS = st.text(max_size=20) | st.sampled_from(["\x1b[2J", "\u202eabc", "a" * 1000, "ONLINE", "FATAL", "n0"])
NUMBERS = st.integers(-(2**60), 2**60) | st.floats(allow_nan=False, allow_infinity=False)
VALUES = st.none() | st.booleans() | NUMBERS | TEXTS
NAMES = (
    "version timestamp orderId lastNodeId nodeStates edgeStates nodeId "
    "sequenceId released nodePosition x y theta mapId "
    "agvPosition positionInitialized batteryState batteryCharge charging errors errorType "
    "errorLevel errorDescription errorHint errorReferences referenceKey referenceValue safetyState "
    "eStop fieldViolation operatingMode actionStates actionId actionType actionStatus "
    "loads loadType paused driving newBaseRequest connectionState typeSpecification "
    "physicalParameters nodes edges edgeId startNodeId endNodeId actions "
)
KEYS = st.sampled_from(NAMES.split())
ANY: st.SearchStrategy[Any] = st.recursive(
    VALUES,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=6),
    max_leaves=25,
)
OBJECTS = st.dictionaries(KEYS, ANY, max_size=12).map(msgspec.json.encode)
PAYLOADS = OBJECTS | ANY.map(msgspec.json.encode) | st.binary(max_size=40)
TOPICS = (
    st.sampled_from([f"{BASE}/{name}" for name in READ] + [f"uagv/v1/KIT/0001/{name}" for name in READ])
    | TEXTS
)
MESSAGES = st.lists(st.tuples(TOPICS, PAYLOADS, st.booleans(), st.floats(0, 40)), max_size=6)


@given(MESSAGES)
def test_any_message_in_any_order(messages: list[tuple[str, bytes, bool, float]]) -> None:
    site = VehicleSite()
    for topic, payload, kept, seconds in messages:
        base, _, name = topic.rpartition("/")
        site.read(name, payload, kept, base)
        site.wait(seconds)
    agv, state = site.agv, site.state
    assert reasons(state, agv)
    shown = [run for line in (*vehicle_rows(state, agv), *factsheet_rows(agv)) for run in line]
    assert all(harmless(text) for text, _ in (*shown, *news(state, agv)))
