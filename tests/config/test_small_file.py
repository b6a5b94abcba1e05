"""Files that people write: never more than fits their purpose."""

from pathlib import Path

import pytest

from fleet_tui.config.small_file import LARGEST, read_text, read_toml


def test_a_file_is_whole_or_refused(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_text("é" * 10)
    assert read_text(path, 20) == "é" * 10
    with pytest.raises(ValueError, match="over 19 bytes"):
        read_text(path, 19)
    path.write_bytes(b"\xff")
    with pytest.raises(ValueError):
        read_text(path, 20)


def test_toml_is_read_and_bombs_are_not(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_text("[a.b]\nc = 1\n")
    assert read_toml(path) == {"a": {"b": {"c": 1}}}
    for bomb in (".".join(["a"] * 40) + " = 1", "a = 1\n" + "#" * LARGEST):
        path.write_text(bomb)
        with pytest.raises(ValueError):
            read_toml(path)
