"""`fleet-tui routine list`."""

import json
from pathlib import Path

from tests.support.command_line import run
from tests.support.routine_files import ONE_ROBOT, routine


def test_each_routine_with_its_times_and_problems(tmp_path: Path) -> None:
    (tmp_path / "config.toml").write_text(ONE_ROBOT)
    none = run("routine", "list", cwd=tmp_path)
    assert (
        none.returncode == 0
        and none.stdout.startswith("no routine in ")
        and "fleet-tui docs routines" in none.stdout
    )
    routine(tmp_path, "every weekday 06:30\nfor robot_0\nwait 1 s\nend\n", "morning")
    routine(tmp_path, "for robot_0\ngo\nwait\nend\n", "bad")
    done = run("routine", "list", cwd=tmp_path)
    bad, morning = done.stdout.splitlines()
    assert done.returncode == 1 and morning == "morning  weekday 06:30; robot_0; never run"
    assert bad.startswith("bad      no time; robot_0; never run; line 2: usage: go PLACE, and 1 more problem")
    found = json.loads(run("routine", "list", "--json", cwd=tmp_path).stdout)
    assert found["version"] == 1 and [one["name"] for one in found["routines"]] == ["bad", "morning"]
    assert found["routines"][1]["times"] == ["weekday 06:30"]
