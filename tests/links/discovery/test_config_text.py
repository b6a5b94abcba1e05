"""Results of discovery as the text of a configuration that passes the check."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.load import read
from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.config_text import render
from fleet_tui.links.discovery.recognition import discover
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.nav2.vocabulary import VOCABULARY as NAV2
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY

TOPICS, SERVICES = VOCABULARY.topics, VOCABULARY.services
TYPES = [type_ for _, type_ in (*TOPICS.values(), *SERVICES.values(), *NAV2.topics.values())]
TYPES += [type_.replace("/", "/msg/") for _, type_ in NAV2.topics.values()]
WORDS = "r1 r2 pose queue graph map f0 map_metadata Pause paused floor navigate_to_pose amcl_pose odom"
PART = st.sampled_from([*WORDS.split(), "battery_state", "lifecycle_manager_navigation/is_active"])
NAME = st.lists(PART | st.text(max_size=3), min_size=1, max_size=4).map(lambda parts: "/" + "/".join(parts))
NAMES = st.dictionaries(NAME, st.sampled_from(TYPES) | st.text(max_size=5), max_size=12)


def test_one_floor_takes_the_frame_of_the_poses() -> None:
    topics = {"/r/pose": TOPICS["pose"][1], "/r/ground/graph": TOPICS["graph"][1]}
    text = render(Link(), discover(Listed(topics, {})), {"r": "map"})
    assert tomllib.loads(text)["floors"] == [{"name": "ground", "frame_id": "map"}]


def test_any_frame_can_be_written() -> None:
    topics = {"/r/pose": TOPICS["pose"][1], "/r/ground/graph": TOPICS["graph"][1]}
    frame = '\U00010000\x85\x7f\n"é'
    text = render(Link(), discover(Listed(topics, {})), {"r": frame})
    assert text.isascii() and tomllib.loads(text)["floors"] == [{"name": "ground", "frame_id": frame}]


@given(
    topics=NAMES,
    services=NAMES,
    actions=st.lists(NAME, max_size=4),
    frames=st.dictionaries(PART, st.text(max_size=5), max_size=3),
)
def test_whatever_is_there_the_result_passes_the_check(
    tmp_path_factory: pytest.TempPathFactory,
    topics: dict[str, str],
    services: dict[str, str],
    actions: list[str],
    frames: dict[str, str],
) -> None:
    text = render(Link(), discover(Listed(topics, services, tuple(actions))), frames)
    path = tmp_path_factory.getbasetemp() / "any.toml"
    path.write_text(text, encoding="utf-8")
    assert read(path)[1] == [], text
