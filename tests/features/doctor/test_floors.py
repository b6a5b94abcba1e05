"""The doctor's judgement of floors: map and metadata agree, vertices and robots are on free ground."""

import numpy as np
import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry
from fleet_tui.features.doctor.floors import FloorFiles, floor_findings, place_finding, placed_grid
from fleet_tui.features.doctor.surveys import FloorSurvey
from fleet_tui.links.discovery.facts import TopicFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from fleet_tui.model.events import Event, FloorMapLoaded, FrameReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.navigation_events import LocalisationReported
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.robots.adapter import Feed
from fleet_tui.text.language import Message
from tests.support.fleets import F0, R0, T0, graph, pose
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 1, 2)
FRAME = MapFrame(1.0, 4, 1, Pose(-0.5, -0.5))
GRID = build_grid(FRAME, np.array([[FREE, FREE, OCCUPIED, UNKNOWN]], np.uint8))
FLOOR = FloorEntry(F0, "hall.yaml")


def received(*events: Event) -> list[TopicFacts]:
    return [TopicFacts(Feed("", (R0,), F0, "", ""), event=event) for event in events]


def judged(loaded: FloorMapLoaded | None, *events: Event) -> dict[str, Finding]:
    found = floor_findings(CONFIG, FLOOR, FloorFiles(loaded), [], received(*events))
    return {finding.check: finding for finding in found}


def test_a_map_that_fits_what_the_robots_say_is_well() -> None:
    found = judged(FloorMapLoaded(F0, GRID), graph(1, 2), FrameReceived(R0, F0, FRAME))
    assert {finding.verdict for finding in found.values()} == {Verdict.OK}
    assert found["vertices"].measured == "2 vertices, all on free ground"
    assert found["map"].measured == "hall.yaml: 4 x 1 px, 1 m each"


def test_a_map_that_is_missing_or_unreadable_is_named() -> None:
    bad = judged(FloorMapLoaded(F0, None, Message("map hall.yaml: no image")), graph(1))
    assert bad["map"].verdict is Verdict.FAIL and bad["map"].measured == "map hall.yaml: no image"
    none = judged(None, graph(1))
    assert (none["map"].verdict, none["vertices"].verdict) == (Verdict.WARN, Verdict.SKIPPED)


@pytest.mark.parametrize(
    ("told", "tied", "fits"),
    [
        (replace(FRAME, width=5), True, False),
        (replace(FRAME, resolution=1.1), True, False),
        (replace(FRAME, origin=Pose(0.6, -0.5)), True, False),
        (replace(FRAME, origin=Pose(0.4, -0.5)), True, True),
        (replace(FRAME, resolution=1.1, origin=Pose(9.0, 9.0)), False, True),
    ],
)
def test_map_and_metadata_describe_one_map(told: MapFrame, tied: bool, fits: bool) -> None:
    found = judged(FloorMapLoaded(F0, GRID, tied=tied), FrameReceived(R0, F0, told))["map size"]
    assert found.verdict is (Verdict.OK if fits else Verdict.FAIL)


@pytest.mark.parametrize(
    ("vertices", "verdict", "words"),
    [
        ((1, 2, 3), Verdict.FAIL, "1 of 3 vertices in a wall: 3 at (2.00, 0.00)"),
        ((1, 2, 3, 4, 5), Verdict.FAIL, "1 of 5 vertices off the map: 5"),
        ((), Verdict.FAIL, "none in the graph"),
    ],
)
def test_vertices_off_the_map_and_in_walls(vertices: tuple[int, ...], verdict: Verdict, words: str) -> None:
    found = judged(FloorMapLoaded(F0, GRID), graph(*vertices))["vertices"]
    assert found.verdict is verdict and words in found.measured


def test_a_plain_image_lies_where_the_metadata_says() -> None:
    plain, told = FloorMapLoaded(F0, GRID, tied=False), replace(FRAME, origin=Pose(7.0, 7.0))
    placed = placed_grid(plain, [], F0, FloorSurvey(frame=told))
    assert placed is not None and placed.frame == told and placed.levels is GRID.levels
    assert placed_grid(plain, [], F0, FloorSurvey()) is None
    assert placed_grid(FloorMapLoaded(F0, GRID), [], F0, FloorSurvey(frame=told)) is GRID


@pytest.mark.parametrize(
    ("x", "frame", "verdict", "words"),
    [
        (0.0, F0, Verdict.OK, "(0.00, 0.00) on floor_0, free ground"),
        (3.0, F0, Verdict.OK, "unknown ground"),
        (2.0, F0, Verdict.WARN, "is in a wall"),
        (9.0, F0, Verdict.FAIL, "is off the map"),
        (0.0, "floor_1", Verdict.WARN, "on floor_1, not one of its floors"),
        (0.0, "floor_o", Verdict.FAIL, "pose frame 'floor_o' matches no floor"),
    ],
)
def test_a_robot_stands_on_ground_of_a_floor_it_knows(
    x: float, frame: str, verdict: Verdict, words: str
) -> None:
    found = place_finding(CONFIG, pose(T0, x, frame=frame), {F0: GRID}, [F0], "")
    assert found.verdict is verdict and words in found.measured


def test_where_the_frame_names_no_floor_the_robots_own_word_does() -> None:
    at = LocalisationReported(R0, T0, Pose(0.0, 0.0), "map", T0, None)
    assert place_finding(CONFIG, at, {F0: GRID}, [F0], F0).verdict is Verdict.OK
    unknown = place_finding(CONFIG, at, {F0: GRID}, [F0], "")
    assert unknown.verdict is Verdict.WARN and "on an unknown floor" in unknown.measured
    assert place_finding(CONFIG, at, {}, [F0], F0).verdict is Verdict.SKIPPED
