"""The live map of a simulated robot that maps: it grows, and its size and origin change."""

import numpy as np

from fleet_tui.simulator.floorplan import ORIGIN, UNKNOWN
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.senses.mapping import Surveys
from tests.support.navigating import FLOOR, robot


def surveys() -> Surveys:
    it = robot()
    return Surveys({it.name: it}, lambda floor: [f"/{floor.name}/map"])


def test_without_mapping_it_is_the_whole_map() -> None:
    it = surveys()
    it.step(9.0)
    assert it.cells(FLOOR) == (FLOOR.cells, ORIGIN) and list(it.news(lambda _: {})) == []


def test_a_map_begins_with_what_the_laser_sees_and_grows() -> None:
    it = robot()
    maps = Surveys({it.name: it}, lambda floor: [f"/{floor.name}/map"])
    maps.switch("robot_0", True)
    assert maps.cells(FLOOR)[0].shape == (1, 1)
    maps.step(0.1)
    small, _ = maps.cells(FLOOR)
    far = FLOOR.graph.vertices[max(FLOOR.graph.vertices)]
    it.drive([it.pose.after(it.pose.inverse)])
    it.pose = type(it.pose)(far.x, far.y)
    maps.step(1.0)
    large, _ = maps.cells(FLOOR)
    assert 1 < small.size < large.size <= FLOOR.cells.size
    assert (large != UNKNOWN).sum() > (small != UNKNOWN).sum()
    maps.switch("robot_0", False)
    maps.step(9.0)
    assert np.array_equal(maps.cells(FLOOR)[0], large), "what was mapped stays"


def test_modes_and_maps_are_news() -> None:
    it = surveys()
    (mode,) = it.topics(ROS1)
    assert mode.payload(0.0).msg == {"data": "navigation"}
    it.switch("robot_0", True)
    it.step(0.1)
    news = {topic: payload.msg for topic, payload in it.news(lambda floor: {"of": floor.name})}
    assert news == {"/robot_0/mode": {"data": "mapping"}, f"/{FLOOR.name}/map": {"of": FLOOR.name}}
    assert list(it.news(lambda _: {})) == []
