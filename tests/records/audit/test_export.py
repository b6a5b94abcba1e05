"""Records in a spreadsheet: no formula, nothing lost, readable only by the owner."""

import csv
import io
import stat
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.export import COLUMNS, cell, export, write_csv
from tests.support.records import ANA, record


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t", "\r", "\n", "\uff1d"])
def test_no_cell_is_a_formula(start: str) -> None:
    assert cell(f"{start}cmd|' /C calc'!A0").startswith("'")
    assert cell("Base = 3") == "Base = 3" and cell(None) == "" and cell(-3) == "-3"


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\uff1d", '"=', " ="])
def test_nor_where_a_semicolon_ends_a_cell(start: str) -> None:
    """So it does in a spreadsheet that writes decimals with a comma."""
    file = io.StringIO(newline="")
    write_csv(file, [record(f"Base, 1;{start}1+1")])
    cells = file.getvalue().split(";")[1:]
    assert [one.lstrip(' "')[0] for one in cells] == ["'"]


@given(st.text(max_size=40))
def test_what_a_spreadsheet_reads_back(text: str) -> None:
    file = io.StringIO(newline="")
    assert write_csv(file, [record(text)]) == 1
    names, row = csv.reader(io.StringIO(file.getvalue(), newline=""))
    assert tuple(names) == COLUMNS
    found = row[COLUMNS.index("words")]
    assert not found.startswith(("=", "+", "-", "@", "\t", "\r"))
    assert all(letter.isprintable() or letter == "\ufffd" for letter in found)


def test_an_export_is_for_its_owner_and_never_overwrites(tmp_path: Path) -> None:
    path = tmp_path / "audit.csv"
    assert export(path, [record(), record()]) == 2
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert path.read_text().count("\n") == 3
    with pytest.raises(FileExistsError):
        export(path, [])
    assert ANA.operator in path.read_text()


def test_an_export_that_fails_leaves_no_half_file(tmp_path: Path) -> None:
    def records() -> Iterator[AuditRecord]:
        yield record()
        raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space left"):
        export(tmp_path / "audit.csv", records())
    assert list(tmp_path.iterdir()) == []
