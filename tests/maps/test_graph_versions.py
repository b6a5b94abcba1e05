"""Versions of graphs on disk: the last ones, readable by their owner alone."""

from pathlib import Path

import pytest

from fleet_tui.maps.graph_versions import KEPT, keep_version


def test_the_last_versions_of_each_floor_are_kept(tmp_path: Path) -> None:
    other = keep_version(tmp_path, "robot_0", "floor_1", "other")
    paths = [keep_version(tmp_path, "robot_0", "floor_0", f"version {n}") for n in range(KEPT + 3)]
    left = sorted(path for path in (tmp_path / "graphs").iterdir() if path != other)
    assert left == paths[3:] and other.exists()
    assert left[-1].read_text() == f"version {KEPT + 2}"
    assert {path.stat().st_mode & 0o777 for path in left} == {0o600}
    assert left[0].name.startswith("robot_0-floor_0-2") and left[0].suffix == ".yaml"


def test_the_same_graph_again_is_no_new_version(tmp_path: Path) -> None:
    first = keep_version(tmp_path, "r", "f", "one")
    assert keep_version(tmp_path, "r", "f", "one") == first
    assert keep_version(tmp_path, "r", "f", "two") != first


def test_a_clock_put_back_costs_nothing(tmp_path: Path) -> None:
    (tmp_path / "graphs").mkdir()
    for n in range(KEPT):
        (tmp_path / "graphs" / f"r-f-9{n:03}.yaml").write_text("from the future")
    path = keep_version(tmp_path, "r", "f", "now")
    assert path.read_text() == "now" and len(list((tmp_path / "graphs").iterdir())) == KEPT


def test_a_name_leads_nowhere_else(tmp_path: Path) -> None:
    assert keep_version(tmp_path, "../x", "a/b", "").parent == tmp_path / "graphs"


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError):
        keep_version(tmp_path / "file", "r", "f", "")
