"""The audit log, followed."""

from contextlib import closing
from pathlib import Path

from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import encode
from fleet_tui.records.audit.tail import AuditTail
from fleet_tui.storage.line_file import LineFile
from tests.support.records import record


def test_only_what_is_new_and_each_record_once(tmp_path: Path) -> None:
    file = audit_file(tmp_path / FILE_NAME)
    file.append(encode(record("old")))
    with closing(AuditTail(file.path)) as tail:
        assert list(tail.new()) == []
        file.append(encode(record("one")))
        file.append(b"rubbish\n")
        assert [one.words for one in tail.new()] == ["one"]
        assert list(tail.new()) == []


def test_half_a_line_waits_for_its_end(tmp_path: Path) -> None:
    path = tmp_path / FILE_NAME
    path.write_bytes(b"")
    line = encode(record("whole"))
    with closing(AuditTail(path)) as tail, path.open("ab", buffering=0) as file:
        file.write(line[:20])
        assert list(tail.new()) == []
        file.write(line[20:])
        assert [one.words for one in tail.new()] == ["whole"]


def test_nothing_is_missed_when_it_is_rotated(tmp_path: Path) -> None:
    lines = [encode(record(str(number))) for number in range(9)]
    file = LineFile(tmp_path / FILE_NAME, max_bytes=3 * len(lines[0]), kept=9)
    with closing(AuditTail(file.path)) as tail:
        found = []
        for line in lines:
            file.append(line)
            found += [one.words for one in tail.new()]
    assert found == [str(number) for number in range(9)]


def test_a_log_that_begins_later(tmp_path: Path) -> None:
    path = tmp_path / FILE_NAME
    with closing(AuditTail(path)) as tail:
        assert list(tail.new()) == []
        audit_file(path).append(encode(record("first")))
        assert [one.words for one in tail.new()] == ["first"]
