"""Bags by their names."""

from pathlib import Path

from fleet_tui.features.recording.bags.opening import is_bag


def test_a_bag_is_told_by_its_name(tmp_path: Path) -> None:
    assert is_bag(tmp_path) and is_bag(Path("a.bag")) and is_bag(Path("a.db3")) and is_bag(Path("a.mcap"))
    assert not is_bag(Path("night.jsonl.gz")) and not is_bag(Path("bag"))
