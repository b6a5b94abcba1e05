"""Whatever a bag is: a message in one line, or what can be read of it. Never a crash, never code of it."""

import os
import resource
import sqlite3
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from backports import zstd
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.features.recording.bags import convert as converting
from fleet_tui.features.recording.bags.convert import convert
from fleet_tui.features.recording.bags.opening import BagError
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.text.errors import FleetError
from tests.support.bag_replay import battery, made_of, night, played, pose
from tests.support.bags import KINDS, Said, bag_config, written
from tests.support.fleets import R0


def said_of(bag: Path, folder: Path) -> str:
    """The error of a bag, which is one line and leaves nothing behind."""
    form = "ros1" if bag.suffix == ".bag" else "mcap"
    with pytest.raises(BagError) as raised:
        convert(bag, bag_config(form), folder / "r.jsonl.gz")
    assert not (folder / "r.jsonl.gz").exists()
    assert "\n" not in str(raised.value) and len(str(raised.value)) < 1000
    return str(raised.value).replace(str(bag), "BAG")


@pytest.fixture
def files(tmp_path: Path) -> Iterator[Path]:
    (tmp_path / "empty.bag").touch()
    (tmp_path / "empty.mcap").touch()
    (tmp_path / "empty.db3").touch()
    (tmp_path / "text.bag").write_text("Dear diary\n")
    (tmp_path / "text.mcap").write_text("Dear diary, this is longer than a footer of mcap has to be\n")
    (tmp_path / "text.db3").write_text("Dear diary\n")
    (tmp_path / "old.bag").write_text("#ROSBAG V1.2\n")
    (tmp_path / "folder").mkdir()
    (tmp_path / "lost").mkdir()
    (tmp_path / "lost" / "lost_0.db3").touch()
    (tmp_path / "yaml").mkdir()
    (tmp_path / "yaml" / "metadata.yaml").write_text("rosbag2_bagfile_information: 7\n")
    (tmp_path / "huge").mkdir()
    with (tmp_path / "huge" / "metadata.yaml").open("wb") as file:
        file.truncate(2**25)
    (tmp_path / "code").mkdir()
    (tmp_path / "code" / "metadata.yaml").write_text("a: !!python/object/apply:os.system ['touch ran']\n")
    os.mkfifo(tmp_path / "pipe.bag")
    os.mkfifo(tmp_path / "lost" / "pipe.mcap")
    yield tmp_path


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("none.bag", "BAG: no such file"),
        ("empty.bag", "BAG: empty"),
        ("empty.mcap", "BAG: empty"),
        ("empty.db3", "BAG: not a bag"),
        ("text.bag", "BAG: not a bag"),
        ("text.mcap", "BAG: not a bag"),
        ("text.db3", "BAG: unreadable: Cannot open database text.db3: "),
        ("old.bag", "BAG: unreadable: Bag version 102 is not supported."),
        ("folder", "BAG: not a bag: no metadata.yaml, .bag, .db3 or .mcap in it"),
        ("lost", "BAG: no metadata.yaml in it: name one of its files (lost_0.db3, pipe.mcap), or repair"),
        ("yaml", "BAG: unreadable: Invalid bag metadata: "),
        ("huge", "BAG/metadata.yaml: is larger than 16,777,216 bytes: not a metadata.yaml"),
        ("code", "BAG: unreadable: "),
        ("pipe.bag", "BAG: not a file"),
    ],
)
def test_what_is_no_bag_is_named_with_the_remedy(files: Path, name: str, words: str) -> None:
    assert said_of(files / name, files).startswith(words)
    assert not Path("ran").exists() and not (files / "ran").exists()


def test_a_folder_of_ros_1_bags_has_no_metadata_to_mend(tmp_path: Path) -> None:
    (tmp_path / "bags").mkdir()
    written(tmp_path / "bags", "ros1", [])
    said = said_of(tmp_path / "bags", tmp_path)
    assert said == "BAG: no metadata.yaml in it: name one of its files (night.bag)"


def test_a_bag_without_messages_is_empty(tmp_path: Path) -> None:
    assert "empty: no topics in it" in said_of(written(tmp_path, "ros1", []), tmp_path)
    assert "empty: no topics in it" in said_of(written(tmp_path, "mcap", []), tmp_path)


def test_without_rosbags_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bag = written(tmp_path, "ros1", night())
    monkeypatch.setitem(sys.modules, "rosbags.rosbag1", None)
    assert "pip install 'fleet-tui[bags]'" in said_of(bag, tmp_path)


def test_a_bag_that_was_cut_off_names_what_mends_it(tmp_path: Path) -> None:
    ros1 = written(tmp_path, "ros1", night())
    whole = ros1.read_bytes()
    ros1.write_bytes(whole[: len(whole) // 2])
    assert "repair a ROS 1 bag with `rosbag reindex night.bag`" in said_of(ros1, tmp_path)
    # As rosbag leaves it: the place of the index is written last.
    at = whole.index(b"index_pos=") + len(b"index_pos=")
    ros1.write_bytes(whole[:at] + bytes(8) + whole[at + 8 :])
    assert "no index" in said_of(ros1, tmp_path)
    [mcap] = written(tmp_path, "mcap", night()).glob("*.mcap")
    mcap.write_bytes(mcap.read_bytes()[:-100])
    assert "repair it with `mcap recover night.mcap -o mended.mcap`" in said_of(mcap, tmp_path)


def file_of(bag: Path) -> Path:
    if bag.is_file():
        return bag
    [file] = [file for file in bag.iterdir() if file.name != "metadata.yaml"]
    return file


@pytest.mark.parametrize("form", KINDS)
def test_damage_is_an_error_or_what_could_be_read(form: str, tmp_path: Path) -> None:
    bag = written(tmp_path, form, night())
    file, config = file_of(bag), bag_config(form)
    whole = file.read_bytes()
    read = []

    # The same each time: the last line wants some that can be read.
    @settings(max_examples=settings().max_examples // 2, deadline=None, database=None, derandomize=True)
    @given(st.integers(0, len(whole) - 1), st.integers(0, 255), st.integers(0, 3))
    def damaged(place: int, byte: int, cut: int) -> None:
        content = bytearray(whole)
        content[place] = byte
        file.write_bytes(content[:place] if cut == 0 else content)
        out = tmp_path / "r.jsonl.gz"
        out.unlink(missing_ok=True)
        try:
            report = convert(bag, config, out)
        except FleetError as problem:
            assert "\n" not in str(problem) and not out.exists()
        else:
            recording = open_recording(out)
            assert recording.note == "" and report.messages + report.unreadable > 0
            played(recording)
            read.append(report)

    damaged()
    assert any(report.messages > 20 for report in read)


def test_memory_is_bounded_while_a_bag_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A message of a gigabyte in a few bytes."""
    monkeypatch.setattr("fleet_tui.features.recording.bags.opening.MEMORY", 2**28)
    bag = written(tmp_path, "sqlite3-message", [pose(0), pose(1)])
    with sqlite3.connect(file_of(bag)) as database:
        bomb = zstd.compress(bytes(2**30))
        database.execute("UPDATE messages SET data = ?", (bomb,))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    said = said_of(bag, tmp_path)
    assert said.endswith("of memory"), said
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 2**20
    assert resource.getrlimit(resource.RLIMIT_AS)[0] == resource.RLIM_INFINITY


def test_a_message_that_is_too_large_is_bad_data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(converting, "LARGEST", 1000)
    said = [pose(0), Said(1, f"/{R0}/queue", "ActionQueue", {"orders": [{"status": "x" * 2000}]}), pose(2)]
    report, recording = made_of(written(tmp_path, "ros1", said), bag_config("ros1"), tmp_path / "r.jsonl.gz")
    assert (report.messages, report.unreadable) == (2, 1)
    assert "the limit for bag messages is 1,000" in played(recording).robots[R0].last_fault


def test_a_message_that_is_none_costs_nothing_else(tmp_path: Path) -> None:
    bag = written(tmp_path, "sqlite3", [pose(0), battery(1, 50.0), pose(2)])
    with sqlite3.connect(file_of(bag)) as database:
        database.execute("UPDATE messages SET data = ? WHERE id = 1", (b"\x00\x01\x00\x00" + b"\xff" * 40,))
    report, recording = made_of(bag, bag_config("sqlite3"), tmp_path / "r.jsonl.gz")
    assert (report.messages, report.unreadable) == (2, 1)
    robot = played(recording).robots[R0]
    assert robot.faults == 1 and robot.last_fault.startswith("/robot_0/pose: ") and robot.pose is not None


@pytest.mark.parametrize("stamp", [-5, "noon", b"noon", None])
def test_a_time_that_can_not_be_is_left_out(tmp_path: Path, stamp: object) -> None:
    bag = written(tmp_path, "sqlite3", [pose(n) for n in range(4)])
    with sqlite3.connect(file_of(bag)) as database:
        database.execute("CREATE TABLE loose (id, topic_id, timestamp, data)")
        database.execute("INSERT INTO loose SELECT * FROM messages")
        database.execute("DROP TABLE messages")
        database.execute("ALTER TABLE loose RENAME TO messages")
        database.execute("UPDATE messages SET timestamp = ? WHERE id = 3", (stamp,))
    report, recording = made_of(bag, bag_config("sqlite3"), tmp_path / "r.jsonl.gz")
    assert (report.messages, report.impossible) == (3, 1)
    assert "1 messages with an impossible time left out" in report.notes
    assert recording.end.at == 4.0
