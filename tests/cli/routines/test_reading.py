"""A routine named on the command line: its problems against the fleet, or those of its text alone."""

from pathlib import Path

from fleet_tui.cli.routines.reading import problems_of
from fleet_tui.routines.files import read_routine
from tests.support.routines import two_robots


def test_a_mistake_in_the_text_comes_before_the_fleet(tmp_path: Path) -> None:
    path = tmp_path / "day.routine"
    for text, lines in (("for robot_0\ngo Bse\nrun absent\nend\n", [2, 3]), ("for robot_9\ngo\nend\n", [2])):
        path.write_text(text)
        found = problems_of(two_robots(), read_routine(tmp_path, "day"))
        assert [problem.line for problem in found] == lines
