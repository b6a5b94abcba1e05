"""The map of a `graph` command is of one floor."""

from pathlib import Path

import pytest
from PIL import Image

from fleet_tui.features.graphs.cli.map_image import map_grid
from fleet_tui.model.graphs.document import DocumentFloor
from fleet_tui.text.errors import GraphError, MapError
from tests.support.graph_files import sample


def test_maps_that_do_not_fit(tmp_path: Path) -> None:
    with pytest.raises(GraphError, match="choose one with --floor"):
        map_grid("m.yaml", sample().with_floor(DocumentFloor("upper")))
    with pytest.raises(MapError, match=r"map m\.yaml: no such file"):
        map_grid(str(tmp_path / "m.yaml"), sample())
    Image.new("L", (4, 4), 254).save(tmp_path / "m.png")
    with pytest.raises(MapError, match="has no place in the world: give its map_server YAML"):
        map_grid(str(tmp_path / "m.png"), sample())
    (tmp_path / "m.yaml").write_text("image: m.png\nresolution: 0.1\norigin: [1, 2, 0]\n")
    assert map_grid(str(tmp_path / "m.yaml"), sample()).frame.origin.x == 1.0
