"""The view of a simulated camera: near walls are tall, far ones short."""

import io

import numpy as np
from PIL import Image

from fleet_tui.model.geometry import Pose
from fleet_tui.robots.ros.set_up.camera import read_image
from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, WIDTH
from fleet_tui.simulator.senses.camera import CEILING, SIZE, jpeg, message, view

CELLS = np.full((HEIGHT, WIDTH), FREE, np.int8)
CELLS[:, 300] = OCCUPIED  # x = 13


def lines_of_wall(pose: Pose) -> int:
    middle = view(CELLS, pose)[:, SIZE[0] // 2].astype(int)
    greys = np.ptp(middle, axis=1)
    return int((greys > np.ptp(CEILING) + 20).sum())


def test_a_wall_is_taller_from_nearby_and_gone_behind_the_robot() -> None:
    far, near = lines_of_wall(Pose(3.0, 5.0)), lines_of_wall(Pose(11.0, 5.0))
    assert 0 < far < near <= SIZE[1]
    assert lines_of_wall(Pose(11.0, 5.0, np.pi)) < far


def test_its_message_is_a_jpeg_that_the_console_reads() -> None:
    found = read_image(message({"frame_id": "lens"}, jpeg(view(CELLS, Pose(3.0, 5.0)))).msg)
    assert Image.open(io.BytesIO(found.data)).size == SIZE
