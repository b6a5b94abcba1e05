"""One file of a recording: readable after each flush, private, and never through a link."""

import gzip
import stat
import zlib
from pathlib import Path

import pytest

from fleet_tui.records.recording.part_file import PartFile


def readable(path: Path) -> bytes:
    """The content of a file that is being written, as a reader sees it."""
    unpack, content = zlib.decompressobj(wbits=31), path.read_bytes()
    found = unpack.decompress(content)
    while unpack.eof and unpack.unused_data:
        content, unpack = unpack.unused_data, zlib.decompressobj(wbits=31)
        found += unpack.decompress(content)
    return found


def test_what_was_flushed_is_readable_while_it_is_written(tmp_path: Path) -> None:
    file = PartFile(tmp_path / "in" / "x.gz", b"head\n")
    assert readable(file.path) == b"head\n" and stat.S_IMODE(file.path.stat().st_mode) == 0o600
    file.write(b"one\n")
    file.flush()
    assert readable(file.path) == b"head\none\n"
    size = file.size
    file.flush()
    assert file.size == size == file.path.stat().st_size, "a second flush adds nothing"
    file.begin_member()
    file.write(b"two\n")
    file.end()
    file.close()
    assert gzip.decompress(file.path.read_bytes()) == b"head\none\ntwo\n"


def test_a_file_or_a_link_with_its_name_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "file").write_text("mine")
    for name in ("link", "file"):
        with pytest.raises(FileExistsError):
            PartFile(tmp_path / name, b"head\n")
    assert not (tmp_path / "elsewhere").exists() and (tmp_path / "file").read_text() == "mine"


def test_a_file_that_was_removed_or_replaced_is_there_no_more(tmp_path: Path) -> None:
    file = PartFile(tmp_path / "x", b"head\n")
    assert file.is_there()
    file.path.unlink()
    assert not file.is_there()
    file.path.touch()
    assert not file.is_there()
    file.close()


def test_a_file_whose_head_cannot_be_written_is_not_left_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_fd: int, _content: bytes) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("fleet_tui.records.recording.part_file.os.write", full)
    with pytest.raises(OSError, match="No space left"):
        PartFile(tmp_path / "x", b"head\n")
    assert list(tmp_path.iterdir()) == []
