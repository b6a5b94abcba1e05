"""Files of a configuration's floors: those that are named, relative to its file, graphs first."""

import json
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace
from PIL import Image

from fleet_tui.config.entries import FloorEntry
from fleet_tui.config.schema import Config
from fleet_tui.maps.floor_files import load_floors, load_graphs, load_maps
from fleet_tui.model.events import FloorGraphLoaded, FloorMapLoaded
from tests.support.watched_store import config_of


@pytest.fixture
def config(tmp_path: Path) -> Config:
    """Of three floors one has both files, and one a map that is not there."""
    Image.fromarray(np.zeros((1, 3), np.uint8)).save(tmp_path / "m.png")
    (tmp_path / "m.yaml").write_text("image: m.png\nresolution: 0.05\norigin: [0, 0, 0]\n")
    (tmp_path / "g.geojson").write_text(json.dumps({"type": "FeatureCollection", "features": []}))
    floors = [FloorEntry("hall", "m.yaml", "g.geojson"), FloorEntry("yard"), FloorEntry("attic", "gone.yaml")]
    return replace(config_of("ws://site:9090"), floors=floors, path=tmp_path / "config.toml")


def test_graphs_come_before_maps_and_a_floor_without_files_has_none(config: Config) -> None:
    found = [(type(event), event.floor) for event in load_floors(config)]
    assert found == [(FloorGraphLoaded, "hall"), (FloorMapLoaded, "hall"), (FloorMapLoaded, "attic")]


def test_a_file_that_is_not_there_is_a_problem_of_its_floor_alone(config: Config) -> None:
    hall, attic = load_maps(config)
    assert hall.grid is not None and not hall.problem
    assert attic.grid is None and "gone.yaml" in attic.problem
    assert [event.floor for event in load_graphs(config)] == ["hall"]
