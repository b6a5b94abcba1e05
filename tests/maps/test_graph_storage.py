"""Graph files on the disk."""

import os
from pathlib import Path

import pytest

from fleet_tui.maps import graph_storage
from fleet_tui.maps.formats.graph_file import ReadChoices
from fleet_tui.maps.graph_storage import graph_text, load_graph_file, save_graph_file
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import sample, write_text


def test_saved_and_read_again(tmp_path: Path) -> None:
    path = tmp_path / "g.yaml"
    text = write_text(sample(), GraphFormat.NATIVE)
    assert save_graph_file(path, text) is None
    assert load_graph_file(path, None, ReadChoices()).document == sample()
    path.chmod(0o640)
    assert save_graph_file(path, "new") == tmp_path / "g.yaml.bak"
    assert (path.read_text(), (tmp_path / "g.yaml.bak").read_text()) == ("new", text)
    assert path.stat().st_mode & 0o777 == 0o640
    assert sorted(one.name for one in tmp_path.iterdir()) == ["g.yaml", "g.yaml.bak"]


def test_a_link_stays_one(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    assert save_graph_file(tmp_path / "link", "new") == tmp_path / "real.bak"
    assert (tmp_path / "link").is_symlink() and (tmp_path / "real").read_text() == "new"


def test_what_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(GraphError, match="is a folder"):
        save_graph_file(tmp_path, "")
    with pytest.raises(GraphError, match="cannot be written: No such file"):
        save_graph_file(tmp_path / "no" / "g", "")
    with pytest.raises(GraphError, match="not a regular file"):
        save_graph_file(Path("/dev/null"), "")
    with pytest.raises(GraphError, match="not a regular file"):
        save_graph_file(Path("/dev/stdout"), "")
    (tmp_path / "g").write_text("old")
    (tmp_path / "g.bak").mkdir()
    (tmp_path / "g.bak" / "g").mkdir()
    with pytest.raises(GraphError, match="cannot be written"):
        save_graph_file(tmp_path / "g", "new")
    assert (tmp_path / "g").read_text() == "old"
    assert sorted(one.name for one in tmp_path.iterdir()) == ["g", "g.bak"]


def test_what_cannot_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "latin").write_bytes(b"name: \xe9")
    os.mkfifo(tmp_path / "pipe")
    for name, problem in (
        ("gone", "no such file"),
        ("latin", "not UTF-8 at byte 6: save it as UTF-8"),
        ("pipe", "unreadable: not a regular file"),
        ("", "is a folder|unreadable"),
    ):
        with pytest.raises(GraphError, match=problem):
            graph_text(tmp_path / name)
    monkeypatch.setattr(graph_storage, "LARGEST", 3)
    with pytest.raises(GraphError, match="unreadable: over 3 bytes"):
        graph_text(tmp_path / "latin")
