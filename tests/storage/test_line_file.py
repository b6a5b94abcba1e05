"""The file of the audit log: kills, several consoles, rotation, modes, full disks."""

import fcntl
import os
import random
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from fleet_tui.records.audit.file import KEPT, audit_file
from fleet_tui.records.audit.log import encode
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.storage.line_file import part
from tests.support.records import record

# Appends numbered records, and says each number once the record is written.
WRITER = """
import sys
from pathlib import Path
from fleet_tui.records.audit.file import audit_file
path, name, first, count, size, limit = sys.argv[1:]
file = audit_file(Path(path), int(limit))
for n in range(int(first), int(first) + int(count)):
    line = '{"version":1,"time":"","operator":"%s","console":"","run":"","kind":"","what":"","change":"%d"'
    file.append((line % (name, n) + ',"words":"' + "x" * int(size) + '"}\\n').encode())
    print(n, flush=True)
"""


def writer(path: Path, name: str, first: int, count: int, size: int, limit: int) -> subprocess.Popen[bytes]:
    numbers = (str(one) for one in (first, count, size, limit))
    return subprocess.Popen([sys.executable, "-c", WRITER, str(path), name, *numbers], stdout=subprocess.PIPE)


def numbers(path: Path, name: str) -> list[int]:
    """The lines of one writer, in the sequence of the files."""
    records = list(AuditReader(path).newest_first())[::-1]
    return [int(one.change) for one in records if one.operator == name]


def test_a_kill_at_any_instant_costs_no_written_record(tmp_path: Path) -> None:
    """Long lines, so that a kill does hit the middle of a write. The files that are kept hold all."""
    path, rng, said, kills = tmp_path / "audit.jsonl", random.Random(1), [], 8
    for n in range(kills):
        with writer(path, "a", n * 1000, 40, 100_000, 10_000_000) as running:
            assert running.stdout is not None
            for _ in range(rng.randrange(1, 12)):
                said.append(int(running.stdout.readline()))
            running.send_signal(signal.SIGKILL)
            said += [int(line) for line in running.stdout.read().split()]
    reading = AuditReader(path)
    found = [int(one.change) for one in reading.newest_first()][::-1]
    assert set(said) <= set(found)
    assert found == sorted(set(found))
    assert reading.unreadable <= kills


def test_two_consoles_never_mix_their_lines(tmp_path: Path) -> None:
    """Also while either of them rotates the file."""
    path, count = tmp_path / "audit.jsonl", 4000
    with (
        writer(path, "a", 0, count, 300, 1_000_000) as one,
        writer(path, "b", 0, count, 300, 1_000_000) as two,
    ):
        for running in (one, two):
            assert running.stdout is not None
            running.stdout.read()
    assert part(path, 2).exists()
    reading = AuditReader(path)
    assert len(list(reading.newest_first())) == 2 * count and reading.unreadable == 0
    assert numbers(path, "a") == numbers(path, "b") == list(range(count))


@pytest.mark.parametrize("left", range(1, len(encode(record("before")))))
def test_a_torn_last_line_never_eats_the_next_record(tmp_path: Path, left: int) -> None:
    path = tmp_path / "audit.jsonl"
    whole = encode(record("before"))
    path.write_bytes(whole + whole[:left])
    reading = AuditReader(path)
    assert [one.words for one in reading.newest_first()] == ["before"]
    assert reading.unreadable == 1
    audit_file(path).append(encode(record("after")))
    assert path.read_bytes().startswith(whole + whole[:left] + b"\n")
    again = AuditReader(path)
    found = [one.words for one in again.newest_first()]
    # Where only its newline was missing, the torn line is a whole record after all.
    missing = left < len(whole) - 1
    assert (found, again.unreadable) == (["after", *["before"] * (2 - missing)], missing)


def test_a_line_torn_by_another_console_is_closed_by_this_one(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    file = audit_file(path)
    file.append(encode(record("one")))
    with path.open("ab") as other:
        other.write(b'{"version":1,"ti')
    file.append(encode(record("two")))
    reading = AuditReader(path)
    assert [one.words for one in reading.newest_first()] == ["two", "one"]
    assert reading.unreadable == 1


def test_old_files_are_kept_up_to_a_number(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    file, line = audit_file(path, max_bytes=1000), encode(record("x" * 200))
    for _ in range(100):
        file.append(line)
    files = sorted(tmp_path.iterdir())
    assert files == [path, *(part(path, n) for n in range(1, KEPT))]
    assert all(one.stat().st_size <= 1000 and one.read_bytes().endswith(b"\n") for one in files)
    assert all(stat.S_IMODE(one.stat().st_mode) == 0o600 for one in files)


def test_a_gap_left_by_a_kill_while_rotating_is_filled_first(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    for name in (path, part(path, 1), part(path, 3), part(path, 4)):
        name.write_bytes(encode(record(name.name)))
    audit_file(path, max_bytes=10).append(encode(record("new")))
    found = [one.words for one in AuditReader(path).newest_first()]
    assert found == ["new", "audit.jsonl", "audit.jsonl.1", "audit.jsonl.3", "audit.jsonl.4"]


def test_a_file_that_another_console_rotates_just_now_is_written_all_the_same(tmp_path: Path) -> None:
    """A holder of the lock may be stopped for hours: it is not waited for."""
    path = tmp_path / "audit.jsonl"
    path.write_bytes(encode(record("old")))
    with path.open("rb") as other:
        fcntl.flock(other, fcntl.LOCK_EX)
        audit_file(path, max_bytes=10).append(encode(record("new")))
    assert [one.words for one in AuditReader(path).newest_first()] == ["new", "old"]
    assert not part(path, 1).exists()


def test_only_its_owner_reads_it_even_where_it_was_open_to_all(tmp_path: Path) -> None:
    path = tmp_path / "state" / "fleet-tui" / "audit.jsonl"
    audit_file(path).append(b"1\n")
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    path.chmod(0o644)
    file = audit_file(path)
    file.append(b"2\n")
    assert stat.S_IMODE(path.stat().st_mode) == 0o600 and file.warning == ""


def test_a_mode_that_can_not_be_mended_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(fd: int, mode: int) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(os, "fchmod", refuse)
    path = tmp_path / "audit.jsonl"
    path.write_bytes(b"")
    path.chmod(0o666)
    file = audit_file(path)
    file.append(b"1\n")
    assert file.warning == "audit.jsonl has mode 666 instead of 600"


def test_a_file_or_folder_that_was_removed_is_made_again(tmp_path: Path) -> None:
    path = tmp_path / "state" / "audit.jsonl"
    file = audit_file(path)
    file.append(b"1\n")
    path.unlink()
    path.parent.rmdir()
    file.append(b"2\n")
    assert path.read_bytes() == b"2\n"


def test_a_pipe_of_that_name_blocks_nobody(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    os.mkfifo(path)
    reader = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    file = audit_file(path)
    with pytest.raises(OSError):
        for _ in range(1000):
            file.append(b"x" * 1000 + b"\n")
    os.close(reader)


# With a limit of the size of files, which is met in the middle of a line as a full disk is.
FULL = """
import resource, sys
from pathlib import Path
from fleet_tui.records.audit.file import audit_file
file = audit_file(Path(sys.argv[1]))
resource.setrlimit(resource.RLIMIT_FSIZE, (250, resource.RLIM_INFINITY))
line, failed = sys.stdin.buffer.read(), 0
for _ in range(4):
    try:
        file.append(line)
    except OSError:
        failed += 1
print(failed)
resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
file.append(line)
"""


def test_a_disk_that_is_full_in_the_middle_of_a_line(tmp_path: Path) -> None:
    path, line = tmp_path / "audit.jsonl", encode(record("x"))
    assert 125 < len(line) < 250
    done = subprocess.run(
        [sys.executable, "-c", FULL, str(path)], input=line, capture_output=True, check=True
    )
    assert done.stdout.strip() == b"3"
    reading = AuditReader(path)
    assert len(list(reading.newest_first())) == 2 and reading.unreadable == 1


def test_a_file_that_another_console_has_just_rotated_is_not_rotated_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, lock = tmp_path / "audit.jsonl", fcntl.flock
    audit_file(path).append(encode(record("one")))

    def overtaken(fd: int, how: int) -> None:
        monkeypatch.setattr(fcntl, "flock", lock)
        audit_file(path, max_bytes=10).append(encode(record("two")))
        lock(fd, how)

    monkeypatch.setattr(fcntl, "flock", overtaken)
    audit_file(path, max_bytes=10).append(encode(record("three")))
    assert [one.words for one in AuditReader(path).newest_first()] == ["three", "two", "one"]
    assert not part(path, 2).exists()
