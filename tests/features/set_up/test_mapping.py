"""Mapping from the console: what its menu says and does, and the map on disk."""

from pathlib import Path

import numpy as np
from msgspec.structs import replace

from fleet_tui.features.set_up.mapping import MappingControls
from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.kind import MAP_SAVE, MAPPING, Kind
from fleet_tui.model.set_up.commands import SetMapping
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene
from tests.support.desk import Desk, ready
from tests.support.fleets import of_kinds
from tests.support.map_pane import FRAME, SCENE

PLAIN = ready().robots["robot_0"].kind
MAPS = replace(PLAIN, accepts=(*PLAIN.accepts, MAPPING))


def mapping(kind: Kind = MAPS, scene: Scene = SCENE) -> tuple[Desk, MappingControls, list[str]]:
    desk, picture = Desk(of_kinds(ready(), kind)), MapPicture()
    lines = desk.begun
    picture.show(scene)
    controls = MappingControls(desk.console(), picture)
    return desk, controls, lines


def test_its_menu_says_what_is_known_and_switches_the_mode_after_a_question() -> None:
    desk, controls, lines = mapping()
    controls.menu()
    (menu,) = desk.menus
    assert "not mapping" in menu.title and "20.0 x 10.0 m" in menu.title and "m2 known" in menu.title
    menu.choose("Mapping on")
    assert desk.backend.submitted == []
    desk.say_yes()
    assert desk.backend.submitted == [SetMapping("robot_0", True)]
    menu.choose("Save this map")
    assert lines == ["save-map floor_0.yaml"]


def test_without_the_mode_the_map_can_still_be_saved_and_the_missing_key_is_named() -> None:
    desk, controls, _ = mapping(PLAIN)
    controls.menu()
    assert desk.menus[0].texts == ["Save this map to a file"]
    assert "mapping_on is empty" in desk.notices.text


def test_a_robot_that_saves_maps_itself_is_asked_by_a_line_with_its_floor() -> None:
    desk, controls, lines = mapping(replace(PLAIN, accepts=(*PLAIN.accepts, MAP_SAVE)))
    controls.menu()
    assert desk.menus[0].texts == ["Save this map to a file", "Store the map on the robot"]
    desk.menus[0].choose("Store the map")
    assert lines == ["store-map robot_0 floor_0"]


def test_a_saved_map_is_read_as_it_was_and_an_old_one_is_kept(tmp_path: Path) -> None:
    desk, controls, _ = mapping()
    for count in range(2):
        typed = controls.typed(f"save-map {tmp_path}/hall.yaml")
        assert typed is not None
        typed.entries[0][1]()
        assert len(desk.answers) == count
        desk.say_yes()
    assert "read back and compared" in desk.notices.text
    loaded = load_floor_map("", tmp_path / "hall.yaml", added=False)
    assert loaded.grid is not None and SCENE.grid is not None
    assert loaded.grid.frame == FRAME and np.array_equal(loaded.grid.levels[0], SCENE.grid.levels[0])
    assert {path.name for path in tmp_path.iterdir()} >= {"hall.yaml.bak", "hall.pgm.bak"}


def test_what_is_missing_is_said(tmp_path: Path) -> None:
    desk, controls, _ = mapping(scene=Scene("floor_0", FRAME))
    controls.menu()
    assert "no map yet" in desk.menus[0].title
    typed = controls.typed("save-map x")
    assert typed is not None and typed.problem == "no map is shown"
    _, controls, _ = mapping()
    typed = controls.typed("save-map")
    assert typed is not None and typed.problem.startswith("a file")
    assert controls.typed("order") is None
    desk, controls, _ = mapping()
    typed = controls.typed(f"save-map {tmp_path}/none/hall.yaml")
    assert typed is not None
    typed.entries[0][1]()
    assert desk.notices.text.startswith("map not saved")
