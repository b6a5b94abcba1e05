"""Argument lists: no shell ever sees a word of the configuration as anything but a word."""

import shlex
import subprocess
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.arguments import change_unit, log, on_host, show, start_kept, start_session, unit_of
from tests.support.stand_ins import BRIDGE, KEPT, REMOTE


def test_a_unit_is_asked_in_utc_and_english_and_never_for_a_password() -> None:
    assert show(BRIDGE)[:4] == ["env", "TZ=UTC", "LC_ALL=C", "systemctl"]
    assert "--user" not in show(BRIDGE) and show(BRIDGE)[-2:] == ["--", "rosbridge.service"]
    own = change_unit(ProgramEntry("b", unit="b.service", user=True), "restart")
    assert own[4:] == [
        "--user",
        "--no-ask-password",
        "--no-pager",
        "--no-block",
        "restart",
        "--",
        "b.service",
    ]


def test_a_command_gets_a_unit_of_its_own_and_ros_as_it_is_sourced_here() -> None:
    environment = {"ROS_DOMAIN_ID": "7", "PATH": "/opt/bin", "SECRET": "x"}
    assert start_kept(KEPT, environment) == [
        *("systemd-run", "--user", "--quiet", "--unit=fleet-tui-program-mapping.service"),
        *("--setenv=ROS_DOMAIN_ID=7", "--setenv=PATH=/opt/bin", "--", "sleep", "60"),
    ]
    elsewhere = ProgramEntry("mapping", start=["sleep", "60"], host="server")
    assert "setenv" not in " ".join(start_kept(elsewhere, environment))
    assert unit_of(KEPT).startswith("fleet-tui-program-"), "routines have units of the user, too"
    assert unit_of(KEPT) == "fleet-tui-program-mapping.service"


@given(st.lists(st.text(st.characters(exclude_characters="\0", exclude_categories=["Cs"])), min_size=1))
def test_another_host_reads_the_same_words(words: list[str]) -> None:
    arguments = on_host(ProgramEntry("p", start=words, host="server"), words)
    assert arguments[0] == "ssh" and "-oBatchMode=yes" in arguments and "-oConnectTimeout=5" in arguments
    assert arguments[-3:-1] == ["--", "server"] and shlex.split(arguments[-1]) == words


def test_logs_are_followed_or_printed(tmp_path: Path) -> None:
    assert "--unit=rosbridge.service" in log(BRIDGE, tmp_path, True)
    assert "--follow" in log(BRIDGE, tmp_path, True)
    assert "--follow" not in log(BRIDGE, tmp_path, True, follow=False)
    assert "--user-unit=fleet-tui-program-mapping.service" in log(KEPT, tmp_path, True)
    assert log(KEPT, tmp_path, False) == ["tail", "-n", "1000", "-F", str(tmp_path / "mapping.log")]
    own = ProgramEntry("d", start=["a"], stop=["b"], status=["c"], log=["docker", "logs", "-f", "d"])
    assert log(own, tmp_path, True) == own.log
    assert log(REMOTE, tmp_path, True)[0] == "ssh"


def test_a_session_is_a_program_of_its_own(tmp_path: Path) -> None:
    assert start_session(KEPT, tmp_path)[1:] == [
        *("-P", "-m", "fleet_tui.programs.session", str(tmp_path), "mapping", "sleep", "60")
    ]


def test_a_process_of_its_own_takes_no_module_from_the_current_folder(tmp_path: Path) -> None:
    planted = tmp_path / "fleet_tui"
    planted.mkdir()
    (planted / "__init__.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')")
    program = ProgramEntry("own", start=["true"])
    subprocess.run(start_session(program, tmp_path / "state"), cwd=tmp_path, check=False, timeout=30)
    assert not (tmp_path / "ran").exists()
