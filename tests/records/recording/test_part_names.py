"""Names of a recording's files."""

from pathlib import Path

import pytest

from fleet_tui.records.recording.part_files import part_path, parts_beside


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("night.jsonl.gz", "night.0001.jsonl.gz"),
        ("night.gz", "night.0001.gz"),
        ("night", "night.0001"),
        ("a.b.jsonl", "a.b.0001.jsonl"),
    ],
)
def test_the_names_of_parts(tmp_path: Path, name: str, part: str) -> None:
    assert part_path(tmp_path / name, 1).name == part
    for one in (name, part):
        (tmp_path / one).touch()
    assert [one.name for one in parts_beside(tmp_path / part)] == [name, part]
