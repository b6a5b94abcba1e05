"""Levels of a hospital from the building file of the traffic editor, with pictures from files."""

import json
from pathlib import Path

import msgspec
import numpy as np
from PIL import Image

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.floorplan import FREE, ORIGIN, RESOLUTION
from tests.support.console_pilot import console
from tests.support.rmf_site import FIRST, Hospital, hospital, rmf_ready


def building_of(site: Hospital) -> str:
    """The building file, its places in metres."""
    levels = {}
    for floor in site.fleet.building.floors:
        numbers = {id_: n for n, id_ in enumerate(floor.graph.vertices)}
        cabins = {id_: {"lift_cabin": [1, "lift_1"]} for id_ in numbers if floor.types[id_] == "elevator"}
        vertices = [
            [one.x, one.y, 0, floor.labels.get(id_, ""), cabins.get(id_, {})]
            for id_, one in floor.graph.vertices.items()
        ]
        both = {"bidirectional": [4, True], "graph_idx": [2, 0]}
        lanes = [[numbers[one.start], numbers[one.end], both] for one in floor.graph.edges]
        levels[floor.name] = {"vertices": vertices, "lanes": lanes}
    return json.dumps({"name": "hospital", "coordinate_system": "cartesian_meters", "levels": levels})


def picture_of(site: Hospital, number: int, folder: Path) -> str:
    """The picture of a level, and the file that places it."""
    floor = site.fleet.building.floors[number]
    shades = np.where(floor.cells == FREE, 254, 0).astype(np.uint8)
    Image.fromarray(shades[::-1]).save(folder / f"{floor.name}.png")
    file = folder / f"{floor.name}.yaml"
    origin = [*ORIGIN, 0.0]
    file.write_text(json.dumps({"image": f"{floor.name}.png", "resolution": RESOLUTION, "origin": origin}))
    return str(file)


async def test_a_building_file_and_pictures_serve_all_levels_from_the_keyboard(tmp_path: Path) -> None:
    async with hospital(robots=1, floors=3) as site:
        file = tmp_path / "hospital.building.yaml"
        file.write_text(building_of(site))
        floors = [
            msgspec.structs.replace(one, graph=str(file), map=picture_of(site, number, tmp_path))
            for number, one in enumerate(site.config.floors)
        ]
        profile = Profile(kind="rmf", topics={"graphs": "", "building": ""})
        config = msgspec.structs.replace(site.config, floors=floors, profile=profile)
        async with console(config) as it:
            state = await it.until(rmf_ready)
            assert [one.graph_problem for one in state.floors.values()] == ["", "", ""]
            await it.until(lambda state: all(one.grid for one in state.floors.values()))
            await it.press("o")
            await it.type("Kitchen")
            await it.press("enter")
            await it.type("Packing 2")
            await it.press("enter")
            seen = set()

            def done(state: FleetState) -> bool:
                seen.add(state.robots[FIRST].floor)
                return any(one.stage is Stage.DONE for one in state.commands)

            await it.until(done)
        sent = site.sent()
    assert [one["type"] for one in sent] == ["robot_task_request"]
    assert seen == {"floor_0", "floor_1", "floor_2"}
