"""An audit log of format 1, from before ids became text, still means what it meant."""

import gzip
import io
import json
from datetime import datetime
from pathlib import Path
from typing import Any

import msgspec
import pytest

from fleet_tui.features.audit.cli import write_records
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.export import write_csv
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.line import line_text
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.audit.search import search_of

FILES = Path(__file__).parents[1] / "recording" / "of_version_1"
MEANING: dict[str, Any] = json.loads(gzip.decompress((FILES / "meaning.json.gz").read_bytes()))
NOW = datetime.now().astimezone()


def has(line: str, typed: str) -> bool:
    return all(word in line.casefold() for word in typed.split())


@pytest.fixture
def audit_log(tmp_path: Path) -> Path:
    path = tmp_path / FILE_NAME
    path.write_bytes(gzip.decompress((FILES / "audit.jsonl.gz").read_bytes()))
    return path


def test_an_audit_log_reads_searches_and_exports_as_it_did(audit_log: Path) -> None:
    reading = AuditReader(audit_log)
    records = list(reading.newest_first())
    assert not reading.unreadable and {record.version for record in records} == {1}
    assert [line_text(record) for record in records] == MEANING["audit"]
    out = io.StringIO(newline="")
    assert write_csv(out, records) == len(records)
    assert out.getvalue().splitlines() == MEANING["csv"]
    for typed in ("dispatch -> receiving", "order 999 refused", "cancel order 2"):
        found = [line_text(record) for record in records if search_of(typed, NOW).wants(record)]
        assert found and found == [line for line in MEANING["audit"] if has(line, typed)]


def test_the_audit_command_prints_an_old_log(audit_log: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fleet_tui.features.audit.cli.state_folder", lambda: audit_log.parent)
    out = io.StringIO()
    assert write_records("", False, False, out) == ""
    assert out.getvalue().splitlines() == MEANING["audit"]


def test_old_and_new_lines_stand_in_one_log(audit_log: Path) -> None:
    old = next(record for record in AuditReader(audit_log).newest_first() if record.order)
    new = msgspec.structs.replace(old, version=2, order="a1f3", start="dock", end="(1.2, 3.4)")
    with audit_log.open("ab") as file:
        file.write(msgspec.json.encode(new) + b"\n")
    reading = AuditReader(audit_log)
    assert next(record.order for record in reading.newest_first()) == "a1f3" and not reading.unreadable


def test_every_field_of_an_old_log_that_was_a_number_is_text() -> None:
    types = {field.name: field.type for field in msgspec.structs.fields(AuditRecord)}
    assert {name for name, type_ in types.items() if type_ == str | None} == {"start", "end", "order"}
