"""A bag becomes a recording: the same picture as if a bridge had sent it, and alarms in time."""

import math
import shutil
from collections.abc import Iterable
from pathlib import Path

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.features.recording.bags.convert import convert
from fleet_tui.features.recording.bags.opening import BagError
from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.link import Phase
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import ReceivedFrame
from fleet_tui.robots.profile import Profile
from fleet_tui.state.reducer import apply
from tests.support.bag_replay import MAP, battery, made_of, nanoseconds, night, played, pose
from tests.support.bags import KINDS, WALL, Said, bag_config, written
from tests.support.fleets import F0, LINK, R0, order, order_queue
from tests.support.recordings import plain


def stamp(at: float) -> float:
    return WALL + int(at) + nanoseconds(at) * 1e-9


def as_told() -> list[tuple[float, events.Event]]:
    """The events of the night, with seconds from the beginning."""
    frame = MapFrame(0.5, 3, 2, Pose(0.0, 0.0, 0.0))
    cells = np.array([0, 100, -1, 0, 50, 0], np.int8).tobytes()
    vertices = {"1": Vertex("1", 1.0, 2.0), "2": Vertex("2", 3.0, 4.0, Role.DOCKING, "charger")}
    queue = order_queue(7, 7, order(7, 1, 2, "Grüße ☃"))
    return [
        (0, events.GridReceived(R0, F0, grid_from_ros(frame, cells), 1.0)),
        (0, events.FrameReceived(R0, F0, frame)),
        (0, events.GraphReceived(R0, F0, RouteGraph(vertices, (Edge("5", "1", "2"),), False))),
        (0, events.LabelsReceived(R0, F0, {"1": "B"})),
        (0.25, events.QueueReported(R0, 1.25, queue)),
        (0.25, events.CargoReported(R0, 1.25, True)),
        *(
            (0.5 + n / 5, events.PoseReported(R0, 1.5 + n / 5, Pose(n / 10, 2.0), F0, stamp(0.5 + n / 5)))
            for n in range(20)
        ),
        *((5 + n, events.BatteryReported(R0, 6.0 + n, 25.0 - 2.5 * n)) for n in range(6)),
    ]


def live(config: Config, told: Iterable[tuple[float, events.Event]], bag: str) -> FleetState:
    """The state after these facts, with a clock that ticks ten times a second beside them."""
    state = initial_state(config, 1.0)
    links = {name: replace(link, url=f"rosbag://{bag}", phase=Phase.UP) for name, link in state.links.items()}
    state = replace(state, links=links, wall=float(WALL))
    ticks, received = 0, None
    for at, event in told:
        while ticks / 10 <= at:
            if received is not None:
                state = apply(state, events.MessageArrived(LINK, received))
                received = None
            state = apply(state, events.TimePassed(1.0 + ticks / 10, WALL + (1.0 + ticks / 10) - 1.0))
            ticks += 1
        state = apply(state, event)
        received = 1.0 + at
    return state


@pytest.mark.parametrize("form", KINDS)
def test_a_bag_makes_the_picture_that_its_messages_mean(form: str, tmp_path: Path) -> None:
    config = bag_config(form)
    bag = written(tmp_path, form, night())
    shares: list[float] = []
    report = convert(bag, config, tmp_path / "r.jsonl.gz", shares.append)
    recording = open_recording(tmp_path / "r.jsonl.gz")
    assert (report.messages, report.topics, report.unreadable, report.late) == (32, 8, 0, 0)
    assert report.seconds == 10.0 and shares[-1] == 1.0
    expected = live(config, as_told(), bag.name)
    assert plain(played(recording)) == plain(expected)
    assert expected.alarms, "a low battery, or nothing was tested of alarms"
    assert [mark.record.what for mark in recording.marks if mark.record.change == "raised"] == ["battery"]
    assert recording.begin.wall == WALL and recording.end.wall == WALL + 10


@pytest.mark.parametrize("form", ["sqlite3", "mcap"])
def test_a_file_of_a_folder_will_do(form: str, tmp_path: Path) -> None:
    bag = written(tmp_path, form, night())
    [file] = [file for file in bag.iterdir() if file.suffix in (".db3", ".mcap")]
    alone = shutil.copy(file, tmp_path / f"alone{file.suffix}")
    _, recording = made_of(Path(alone), bag_config(form), tmp_path / "r.jsonl.gz")
    assert plain(played(recording)) == plain(live(bag_config(form), as_told(), Path(alone).name))


def test_it_is_said_that_it_is_a_bag_and_nothing_secret_is_kept(tmp_path: Path) -> None:
    config = msgspec.structs.replace(bag_config("ros1"), rosbridge=Link("wss://site:9090/?token=hidden"))
    report, recording = made_of(written(tmp_path, "ros1", night()), config, tmp_path / "r.jsonl.gz")
    assert report.notes[0].startswith("from ROS bag night.bag: ")
    link = played(recording).links[LINK]
    assert (link.url, link.is_bag, link.commands_connected) == ("rosbag://night.bag", True, False)
    content = b"".join(record.payload for record in recording.records() if isinstance(record, ReceivedFrame))
    assert "hidden" not in repr(recording.header) and b"hidden" not in content


def test_out_of_order_messages_are_taken_as_they_come(tmp_path: Path) -> None:
    """Parts of a folder overlap where several were written at once."""
    first = written(tmp_path, "sqlite3", [pose(n / 10, 1.0) for n in range(30)], name="first")
    second = written(tmp_path, "sqlite3", [pose(2 + n / 10, 2.0) for n in range(30)], name="second")
    shutil.copy(second / "second.db3", first / "second.db3")
    text = (first / "metadata.yaml").read_text()
    both = text.replace("  - first.db3", "  - first.db3\n  - second.db3")
    assert both != text
    (first / "metadata.yaml").write_text(both)
    report, recording = made_of(first, bag_config("sqlite3"), tmp_path / "r.jsonl.gz")
    assert report.messages == 60 and report.late == 9
    assert "9 messages out of time order" in report.notes[-1]
    times = [record.at for record in recording.records()]
    assert times == sorted(times)


def test_renamed_fields_and_topics_are_read_as_the_profile_says(tmp_path: Path) -> None:
    from rosbags.typesys import Stores, get_types_from_msg, get_typestore

    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg("int32 nr\nint32 from\nint32 to\nstring state", "agv/msg/Task"))
    store.register(get_types_from_msg("int32 last\nint32 now\nTask[] tasks", "agv/msg/Tasks"))
    names = {"queue.last_order_id": "last", "queue.current_order_id": "now", "queue.orders": "tasks"}
    names |= {"order.id": "nr", "order.start": "from", "order.end": "to", "order.status": "state"}
    profile = Profile(topics={"queue": "/{robot}/tasks"}, types={"queue": "agv/Tasks"}, fields=names)
    config = msgspec.structs.replace(bag_config("ros1"), profile=profile)
    task = {"nr": 3, "from": 1, "to": 2, "state": "Q"}
    said = [Said(0, f"/{R0}/tasks", "agv/msg/Tasks", {"last": 3, "now": 3, "tasks": [task]})]
    bag = written(tmp_path, "ros1", said, store)
    _, recording = made_of(bag, config, tmp_path / "r.jsonl.gz")
    assert played(recording).robots[R0].orders == order_queue(3, 3, order(3, 1, 2, "Q"))


@pytest.mark.parametrize("form", ["ros1", "mcap"])
def test_bad_data_is_that_of_the_robot_as_it_is_live(form: str, tmp_path: Path) -> None:
    said = [battery(0, 50.0), battery(1, math.nan), battery(2, math.inf), pose(3)]
    report, recording = made_of(written(tmp_path, form, said), bag_config(form), tmp_path / "r.jsonl.gz")
    robot = played(recording).robots[R0]
    assert report.messages == 4 and robot.faults == 2
    assert robot.battery is not None and robot.battery.value == 50.0
    frames = [record.text for record in recording.records() if isinstance(record, ReceivedFrame)]
    assert frames[1].endswith('"msg":{"data":null}}') and frames[2] == frames[1]


def test_a_large_map_needs_no_process_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fleet_tui.records.recording.play.frames.decode_apart", None)
    frame = {"resolution": 0.05, "width": 2500, "height": 2000, "origin": {"orientation": {"w": 1.0}}}
    said = [Said(0, f"/{R0}/{F0}/map", MAP, {"info": frame, "data": np.full(5_000_000, 100, np.int8)})]
    _, recording = made_of(written(tmp_path, "ros1", said), bag_config("ros1"), tmp_path / "r.jsonl.gz")
    grid = played(recording).robots[R0].maps[F0].grid
    assert grid is not None and grid.frame.width == 2500


def test_the_floors_files_are_loaded(tmp_path: Path) -> None:
    config = bag_config("ros1")
    floors = [FloorEntry(F0, "no_such.png", "no_such.json")]
    config = msgspec.structs.replace(config, floors=floors, path=tmp_path / "config.toml")
    _, recording = made_of(written(tmp_path, "ros1", night()), config, tmp_path / "r.jsonl.gz")
    floor = played(recording).floors[F0]
    assert "no_such.png" in floor.problem and "no_such.json" in floor.graph_problem


def test_each_link_hears_its_own_robots(tmp_path: Path) -> None:
    robots = [RobotEntry("robot_0"), RobotEntry("robot_1", link="north")]
    config = msgspec.structs.replace(
        bag_config("ros1"), robots=robots, links={"north": Link("ws://north:9090")}
    )
    said = [pose(0), pose(1, 4.0, "robot_1"), pose(3)]
    _, recording = made_of(written(tmp_path, "ros1", said), config, tmp_path / "r.jsonl.gz")
    received = [
        (record.link, record.at) for record in recording.records() if isinstance(record, ReceivedFrame)
    ]
    assert received == [(LINK, 1.0), ("north", 2.0), (LINK, 4.0)]
    state = played(recording)
    assert state.links["north"].last_received == 2.0 and state.robots["robot_1"].pose is not None


def test_a_file_that_is_there_stays(tmp_path: Path) -> None:
    bag = written(tmp_path, "ros1", night())
    (tmp_path / "r.jsonl.gz").write_text("mine")
    with pytest.raises(BagError, match="exists"):
        convert(bag, bag_config("ros1"), tmp_path / "r.jsonl.gz")
    assert (tmp_path / "r.jsonl.gz").read_text() == "mine"
