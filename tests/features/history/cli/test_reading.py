"""The history of a site: found by its configuration or address, or why not."""

from contextlib import closing
from pathlib import Path

import click
import pytest

from fleet_tui.config.log_file import state_folder
from fleet_tui.features.history.cli.reading import history_of_site, site_of
from fleet_tui.records.history.database import history_path, open_to_write
from fleet_tui.text.errors import FleetError
from tests.support.routine_files import ONE_ROBOT


@pytest.fixture
def config_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    path = tmp_path / "config.toml"
    path.write_text(ONE_ROBOT)
    return path


def test_a_file_and_an_address_are_two_sites(config_file: Path) -> None:
    site = site_of(str(config_file), None)
    database, _ = open_to_write(history_path(state_folder(), site))
    database.close()
    with history_of_site(site) as history:
        assert history.orders(0.0, 1e12) == []
    with pytest.raises(FleetError, match=r"^no history of ws://other:9090 yet .*an open console writes it"):
        history_of_site(site_of(None, "ws://other:9090")).__enter__()
    with pytest.raises(click.UsageError):
        site_of(str(config_file), "ws://other:9090")


def test_one_that_is_only_begun_is_not_there_yet(config_file: Path) -> None:
    site = site_of(str(config_file), None)
    path = history_path(state_folder(), site)
    path.parent.mkdir(parents=True)
    path.touch()
    with pytest.raises(FleetError, match=r"no history of .* yet"):
        history_of_site(site).__enter__()


def test_one_that_is_switched_off_says_so(config_file: Path) -> None:
    config_file.write_text(f"[history]\ndays = 0\n{ONE_ROBOT}")
    with pytest.raises(FleetError, match="switched off: set days in"):
        history_of_site(site_of(str(config_file), None)).__enter__()


def test_a_damaged_one_is_an_error_with_its_name(config_file: Path) -> None:
    site = site_of(str(config_file), None)
    path = history_path(state_folder(), site)
    path.parent.mkdir(parents=True)
    path.write_bytes(b"no database" * 100)
    with (
        pytest.raises(FleetError, match=f"{path.name}: file is not a database"),
        history_of_site(site) as read,
    ):
        read.orders(0.0, 1.0)


def test_a_history_is_only_read(config_file: Path) -> None:
    site = site_of(str(config_file), None)
    database, _ = open_to_write(history_path(state_folder(), site))
    with closing(database), pytest.raises(FleetError, match="readonly"), history_of_site(site) as history:
        history.database.execute("DELETE FROM notes")
