"""The commands of the configuration: which file they take, and why."""

from pathlib import Path

import pytest

from tests.support.cli import run


async def test_the_file_may_come_from_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "other.toml"
    path.write_text('floors = [{name = "f"}]\nrobots = [{name = "r"}]\n')
    given = await run(tmp_path, "config", "show", "--config", str(path))
    assert given.out.startswith(f"# {path} (option --config)") and 'robots[0].name = "r"\n' in given.out
    monkeypatch.setenv("FLEET_TUI_CONFIG", str(path))
    found = await run(tmp_path, "config", "show", "--origin")
    assert found.out.startswith(f"# {path} (environment: FLEET_TUI_CONFIG)")
    assert "other.toml:2" in next(line for line in found.out.splitlines() if "robots[0].name" in line)


async def test_a_file_that_is_found_says_where_and_options_count_as_they_would(tmp_path: Path) -> None:
    text = 'floors = [{name = "f"}]\nrobots = [{name = "r"}]\n'
    (tmp_path / "fleet-tui").mkdir()
    (tmp_path / "fleet-tui" / "config.toml").write_text(text)
    assert (await run(tmp_path, "config", "show")).out.splitlines()[0].endswith("config.toml (the user's)")
    (tmp_path / "config.toml").write_text(text)
    found = await run(tmp_path, "--read-only", "config", "show", "--drawing", "ascii")
    assert found.out.splitlines()[0].endswith("config.toml (in this folder)")
    assert "operator.read_only = true\n" in found.out and 'ui.drawing = "ascii"\n' in found.out
    assert "did you mean show?" in (await run(tmp_path, "config", "shwo")).err
