"""A configuration of another user, or with files of one, opens without what runs, authorizes or commands."""

from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config import trust
from fleet_tui.config.load import load
from fleet_tui.config.saving import Saving
from fleet_tui.config.schema import Config
from fleet_tui.config.trust import saying_yes
from fleet_tui.config.withholding import TRUST
from fleet_tui.features.routines.files import read_routine
from fleet_tui.features.routines.programs import program_problem
from fleet_tui.text.errors import FleetError, RoutineError
from tests.support.users import give, two_users

pytestmark = two_users
TEXT = """
[links.b]
url = "mqtt://127.0.0.1:1883"
role = "master"
user_env = "BROKER_USER"
password_env = "BROKER_PASSWORD"
[[floors]]
name = "floor_0"
graph = "graph.geojson"
[[robots]]
name = "robot_0"
link = "b"
[notify]
command = ["./notify.sh", "data", "--from=more"]
[[programs]]
name = "bridge"
start = ["true"]
[[programs]]
name = "own"
start = ["FOLDER/own.sh"]
[desk]
folder = "desk"
"""


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a configuration and all its files, safe."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "site"
    for one in (folder, folder / "routines", folder / "desk"):
        one.mkdir()
    (folder / "config.toml").write_text(TEXT.replace("FOLDER", str(folder)))
    for name in (
        "graph.geojson",
        "notify.sh",
        "data",
        "more",
        "own.sh",
        "routines/day.routine",
        "routines/tool",
    ):
        (folder / name).write_text("robot_0: Base\n" if name.endswith("routine") else "{}")
        (folder / name).chmod(0o755)
    return folder


def bare(config: Config) -> bool:
    """Tell whether nothing that needs trust is left."""
    link = config.links["b"]
    left = (config.notify.command, config.programs, config.desk.folder, link.user_env, link.password_env)
    return not any(left) and link.role == "watch"


def test_a_safe_one_is_whole(site: Path) -> None:
    config = load(site / "config.toml")
    assert config.withheld == [] and config.doubt == ""
    assert (config.notify.command, config.desk.folder) == (["./notify.sh", "data", "--from=more"], "desk")
    assert [program.name for program in config.programs] == ["bridge", "own"]
    assert (config.links["b"].role, config.links["b"].user_env) == ("master", "BROKER_USER")


@pytest.mark.parametrize("by", ["file", "folder", "link"])
def test_that_of_another_user_opens_without(site: Path, by: str) -> None:
    path = site / "config.toml"
    if by == "link":
        path = site.parent / "config.toml"
        path.symlink_to(site / "config.toml")
    place = site if by == "folder" else path
    give(place)
    config = load(path)
    (told,) = config.withheld
    assert bare(config) and config.doubt.startswith(f"{place} is not owned by root: chown ")
    assert config.doubt in told and f"; or {TRUST}. Until then: no notify, programs, " in told
    assert [robot.name for robot in config.robots] == ["robot_0"]


def test_a_yes_trusts_the_content_of_now_and_no_other(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = site / "config.toml"
    give(path)
    with saying_yes():
        assert load(path).withheld == []
    monkeypatch.setattr(trust, "_trusted", set())  # as in the next process
    assert not bare(load(path))
    path.write_text(path.read_text() + "# more\n")
    assert bare(load(path))


def test_a_copy_does_not_leave_out_what_is_off(site: Path) -> None:
    give(site / "config.toml")
    with pytest.raises(FleetError, match=r"not saved, parts of it are off: .*is not owned by root"):
        Saving(load(site / "config.toml")).write(str(site / "copy.toml"))
    assert not (site / "copy.toml").exists()


def test_each_file_counts_for_what_uses_it(site: Path) -> None:
    whole = load(site / "config.toml")
    for file, without, told in (
        ("notify.sh", "notify", "notify is off: "),
        ("data", "notify", "notify is off: "),
        ("more", "notify", "notify is off: "),
        ("own.sh", "programs", "program own is off: "),
    ):
        give(site / file)
        config = load(site / "config.toml")
        assert config.withheld == [f"{told}{site / file} is not owned by root: chown root {site / file}"]
        given = getattr(whole, without)
        assert getattr(config, without) != given
        assert replace(config, withheld=[], **{without: given}) == whole
        with saying_yes():  # what runs is no content that could be remembered
            assert load(site / "config.toml").withheld
        (site / file).unlink()
        (site / file).touch()


def test_a_program_that_is_not_there_yet_counts_by_its_folder(site: Path) -> None:
    (site / "notify.sh").unlink()
    assert load(site / "config.toml").notify.command
    text = (site / "config.toml").read_text()
    (site / "config.toml").write_text(text.replace("./notify.sh", "/tmp/not-there-yet.sh"))
    assert load(site / "config.toml").notify.command == []


def test_vehicles_are_led_by_the_graph_of_a_safe_file_alone(site: Path) -> None:
    give(site / "graph.geojson")
    config = load(site / "config.toml")
    assert (config.links["b"].role, config.links["b"].user_env) == ("watch", "BROKER_USER")
    assert config.withheld[0].startswith("vehicles are only watched: ")
    with saying_yes():
        assert load(site / "config.toml").links["b"].role == "master"
    (site / "graph.geojson").write_text("{ }")
    assert load(site / "config.toml").links["b"].role == "watch"


def test_a_desk_is_for_its_group_and_not_for_everybody(site: Path) -> None:
    (site / "desk").chmod(0o2777)
    config = load(site / "config.toml")
    assert config.desk.folder == ""
    assert config.withheld == [
        f"the desk is off: {site / 'desk'} is writable by everyone: chmod o-w {site / 'desk'}"
    ]
    (site / "desk").chmod(0o2770)
    assert load(site / "config.toml").desk.folder == "desk"


def test_a_routine_runs_only_from_a_safe_file_or_a_trusted_content(site: Path) -> None:
    folder = site / "routines"
    give(folder / "day.routine")
    (told,) = load(site / "config.toml").withheld
    assert told.startswith(f"routines are off: {folder / 'day.routine'} is not owned by root: ")
    with pytest.raises(RoutineError, match=f"day.routine is not owned by root: .*; or {TRUST}"):
        read_routine(folder, "day")
    with saying_yes():
        load(site / "config.toml")
    assert read_routine(folder, "day").name == "day"
    (folder / "day.routine").write_text("robot_0: Base > Store\n")
    with pytest.raises(RoutineError):
        read_routine(folder, "day")


def test_a_routine_runs_no_program_of_another_user(site: Path) -> None:
    folder = site / "routines"
    assert program_problem(folder, ["tool"]) == program_problem(folder, ["true"]) == ""
    give(folder / "tool")
    assert program_problem(folder, ["tool"]).startswith(f"{folder / 'tool'} is not owned by root: ")
    assert program_problem(folder, ["true", "tool"]).startswith(f"{folder / 'tool'} is not owned")
