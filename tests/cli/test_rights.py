"""`fleet-tui rights`."""

import os
from pathlib import Path

import pytest

from fleet_tui.cli.rights import rights_lines
from fleet_tui.config import rights


def test_ones_own_rights_and_where_they_come_from(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tmp_path.chmod(0o755)
    file, me = tmp_path / "rights.toml", rights.own_user()
    monkeypatch.setattr(rights, "FILE", file)
    monkeypatch.setattr(rights, "OWNER", os.getuid())
    first, second, third = rights_lines()
    assert first.startswith(f"{me}: setup (") and second.startswith("groups: ")
    assert third == f"no {file}: everybody may do everything"
    file.write_text(f'[dispatch]\nusers = ["{me}"]\n')
    file.chmod(0o644)
    first, _, third = rights_lines()
    assert first.startswith(f"{me}: dispatch (") and third == str(file)
    file.chmod(0o666)
    first, _, third = rights_lines()
    assert first.startswith(f"{me}: view (")
    assert third.startswith(f"refused, so that everybody may only view: {file}: ")
