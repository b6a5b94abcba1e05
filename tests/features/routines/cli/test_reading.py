"""A routine named on the command line."""

from pathlib import Path

import click
import msgspec
import pytest

from fleet_tui.config.load import from_text
from fleet_tui.features.routines.cli.reading import named_routine
from tests.support.routine_files import ONE_ROBOT, routine


def test_it_is_beside_the_configuration(tmp_path: Path) -> None:
    config = msgspec.structs.replace(from_text(ONE_ROBOT), path=tmp_path / "config.toml")
    routine(tmp_path, "for robot_0\nwait 1 s\nend\n")
    assert named_routine(config, "day").path == tmp_path / "routines" / "day.routine"
    with pytest.raises(click.UsageError, match="unknown routine 'dya', did you mean day"):
        named_routine(config, "dya")
