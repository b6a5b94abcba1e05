"""The shared file of facts: no fact is lost or seen twice, in whatever order consoles read and write."""

import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from fleet_tui.records.desk import fact_file
from fleet_tui.records.desk.fact_file import FILE, SHORTEN_EVERY, FactFile, still_counting
from fleet_tui.records.desk.facts import Fact, SharedAcknowledgement, SharedClosure, SharedNote

EDGE = ("floor_0", "1", "2")


def note(id_: str, text: str = "x") -> SharedNote:
    return SharedNote(id_, "ana", 0.0, text)


def closure(id_: str, closed: bool = True) -> SharedClosure:
    return SharedClosure(id_, "ana", 0.0, EDGE, closed)


def append(file: FactFile, facts: list[Fact]) -> None:
    with file.appending() as write:
        for fact in facts:
            write(fact)


STEPS = st.lists(
    st.tuples(st.integers(0, 3), st.sampled_from(["append", "append", "read", "shorten", "garbage"])),
    max_size=60,
)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(STEPS)
def test_no_update_is_lost_in_any_interleaving(
    tmp_path_factory: pytest.TempPathFactory, steps: list[tuple[int, str]]
) -> None:
    """Four consoles append and read in any order, while the file is written again and torn in between: each
    of them has every fact once, all in the same order."""
    folder = tmp_path_factory.mktemp("desk")
    files = [FactFile(folder) for _ in range(4)]
    seen: list[list[str]] = [[] for _ in files]
    told = list[str]()
    for number, (console, step) in enumerate(steps):
        file = files[console]
        match step:
            case "append":
                facts: list[Fact] = [note(f"c{console}:{number}"), closure(f"c{console}:{number}e")]
                append(file, facts)
                told += [fact.id for fact in facts]
            case "read":
                seen[console] += [fact.id for fact in file.read()]
            case "shorten" if told:
                with pytest.MonkeyPatch.context() as patch:
                    patch.setattr(fact_file, "LARGEST", 1)
                    append(file, [note(f"c{console}:{number}s")])
                    file.shorten(number * SHORTEN_EVERY)
                told.append(f"c{console}:{number}s")
            case "garbage":
                with (folder / FILE).open("ab") as torn:
                    torn.write(b'{"fact": "note", "id": "torn')
    for file, ids in zip(files, seen, strict=True):
        ids += [fact.id for fact in file.read()]
        file.close()
    for ids in seen:
        assert ids == told


def test_a_console_that_reads_on_misses_nothing_of_a_file_that_was_written_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader, writer = FactFile(tmp_path), FactFile(tmp_path)
    append(writer, [closure("a:1")])
    assert [fact.id for fact in reader.read()] == ["a:1"]
    append(writer, [closure("a:2", closed=False)])
    monkeypatch.setattr(fact_file, "LARGEST", 1)
    monkeypatch.setattr(fact_file, "RECENT", 1)
    append(writer, [closure("a:3")])
    writer.shorten(0.0)
    assert len((tmp_path / FILE).read_bytes().splitlines()) == 1
    append(writer, [closure("a:4", closed=False)])
    assert [fact.id for fact in reader.read()] == ["a:2", "a:3", "a:4"]
    reader.close()


def full(_path: Path, _content: bytes) -> None:
    raise OSError(28, "No space left on device")


def test_a_file_that_can_not_be_shortened_is_tried_again_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fact_file, "LARGEST", 1)
    monkeypatch.setattr(fact_file, "RECENT", 1)
    file = FactFile(tmp_path)
    append(file, [closure("a:1"), closure("a:2")])
    with monkeypatch.context() as patched:
        patched.setattr(fact_file, "replace_shared", full)
        file.shorten(0.0)
        assert file.grows
        file.shorten(SHORTEN_EVERY - 1.0)  # reads all of it: not four times a second
    file.shorten(SHORTEN_EVERY - 1.0)
    assert len((tmp_path / FILE).read_bytes().splitlines()) == 2
    file.shorten(SHORTEN_EVERY)
    assert file.grows == ""
    assert len((tmp_path / FILE).read_bytes().splitlines()) == 1


def test_all_of_a_large_file_was_told_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is read in parts; one that can't be shortened has many."""
    append(FactFile(tmp_path), [note(f"a:{number}") for number in range(20)])
    monkeypatch.setattr(fact_file, "AT_ONCE", 300)
    file = FactFile(tmp_path)
    past = list[str]()
    while file.is_past:
        past += [fact.id for fact in file.read()]
    assert past == [f"a:{number}" for number in range(20)]
    append(FactFile(tmp_path), [note("a:20")])
    assert [fact.id for fact in file.read()] == ["a:20"]
    file.close()


@pytest.mark.parametrize(
    "line",
    [
        '{"fact":"shelved","id":"a:1","by":"ana","wall":0,"source":"robot_0","kind":"offline","seconds":1e308}',
        '{"fact":"note","id":"a:1","by":"ana","wall":1e300,"text":"x"}',
        '{"fact":"note","id":"a:1","by":"ana","wall":-1e300,"text":"x"}',
        '{"fact":"removal","id":"a:1","by":"ana","wall":0,"robot":"robot_0","order":"","stage":"sent",'
        '"request":1' + "0" * 400 + "}",
    ],
)
def test_values_that_nothing_has_are_no_facts(tmp_path: Path, line: str) -> None:
    (tmp_path / FILE).write_text(line + "\n")
    file = FactFile(tmp_path)
    assert file.read() == [] and file.ignored == 1
    file.close()


def test_a_console_that_has_just_come_reads_what_still_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fact_file, "RECENT", 1)
    old: list[Fact] = [
        note("a:1", "keep"),
        closure("a:2"),
        SharedAcknowledgement("a:3", "ana", 0.0, "robot_0", "offline"),
    ]
    assert [fact.id for fact in still_counting([*old, note("a:4")])] == ["a:1", "a:2", "a:4"]
    assert [fact.id for fact in still_counting([*old, closure("a:5", closed=False)])] == ["a:1", "a:5"]
    assert [fact.id for fact in still_counting([*old, closure("a:5", closed=False), note("a:6")])] == [
        "a:1",
        "a:6",
    ]


def test_what_is_no_fact_is_counted_and_does_no_harm(tmp_path: Path) -> None:
    file = FactFile(tmp_path)
    (tmp_path / FILE).write_bytes(
        b"garbage\n\xff\xfe\n" + b"[" * 100_000 + b'\n{"fact":"note","id":1}\n{"fact":"other"}\n'
    )
    append(file, [note("a:1")])
    assert [fact.id for fact in file.read()] == ["a:1"]
    assert file.ignored == 5
    file.close()


def test_a_file_without_an_end_of_line_takes_no_memory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fact_file, "AT_ONCE", 1000)
    file = FactFile(tmp_path)
    (tmp_path / FILE).write_bytes(b"x" * 10_000)
    append(file, [note("a:1")])
    found = [fact.id for _ in range(12) for fact in file.read()]
    assert found == ["a:1"]
    file.close()


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("")
    (tmp_path / FILE).symlink_to(tmp_path / "mine")
    with pytest.raises(OSError):
        append(FactFile(tmp_path), [note("a:1")])
    with pytest.raises(OSError):
        FactFile(tmp_path).read()
    assert (tmp_path / "mine").read_text() == ""


def test_a_full_disk_leaves_no_half_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = FactFile(tmp_path)
    append(file, [note("a:1")])
    whole, write = (tmp_path / FILE).read_bytes(), os.write

    def half(handle: int, data: bytes) -> int:
        return write(handle, data[: len(data) // 2])

    with monkeypatch.context() as patch, pytest.raises(OSError, match="No space left"):
        patch.setattr(os, "write", half)
        append(file, [note("a:2")])
    assert (tmp_path / FILE).read_bytes() == whole
    append(file, [note("a:2")])
    assert [fact.id for fact in file.read()] == ["a:1", "a:2"]
    file.close()
