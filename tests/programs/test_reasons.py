"""Reasons of failures, each with what to do."""

import msgspec
import pytest

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.programs.process import EndedProcess
from fleet_tui.programs.reasons import failure, has_no_systemd, last_line
from fleet_tui.text.language import Message
from tests.support.stand_ins import BRIDGE, REMOTE


@pytest.mark.parametrize(
    ("output", "remedy"),
    [
        ("ana@server: Permission denied (publickey).", "try ssh-copy-id server"),
        ("Host key verification failed.", "connect once with ssh server"),
        ("ssh: Could not resolve hostname server: Name or service not known", "server has no address"),
        ("ssh: connect to host server port 22: Connection refused", "is its sshd running?"),
        ("ssh: connect to host server port 22: Connection timed out", "server does not answer"),
        ("first\nsomething else\n\n", "something else"),
        ("", "exit status 255"),
    ],
)
def test_the_remedy_is_that_of_the_reason(output: str, remedy: str) -> None:
    assert remedy in failure(REMOTE, EndedProcess(255, output))


def test_systemd_and_a_shell_have_remedies_of_their_own() -> None:
    refused = EndedProcess(1, "Failed to start b: Interactive authentication required.")
    assert "polkit" in failure(REMOTE, refused) and "polkit" in failure(BRIDGE, refused)
    assert "install it there" in failure(REMOTE, EndedProcess(127, "sh: 1: systemctl: not found"))
    assert failure(BRIDGE, EndedProcess(5, "Unit b.service not found.")) == "Unit b.service not found."


@pytest.mark.parametrize(
    "last", ["rosmaster: Connection refused", "map hall not found", "Failed to connect to the robot"]
)
def test_words_of_a_sites_own_program_are_neither_sshs_nor_systemds(last: str) -> None:
    own = ProgramEntry("own", start=["own"], stop=["own"], status=["own"])
    assert failure(own, EndedProcess(1, last)) == last
    assert failure(msgspec.structs.replace(own, host="server"), EndedProcess(1, last)) == last


def test_a_late_answer_names_its_host() -> None:
    late = EndedProcess(None, "", Message("no answer within 8 s"), is_late=True)
    assert failure(REMOTE, late) == "server: no answer within 8 s"
    assert failure(BRIDGE, late) == "no answer within 8 s"


def test_no_systemd_is_told_from_other_failures() -> None:
    assert has_no_systemd(EndedProcess(1, "Failed to connect to bus: No medium found"))
    assert has_no_systemd(EndedProcess(None, "", Message("systemctl: not found: install it")))
    assert not has_no_systemd(EndedProcess(1, "Access denied"))
    assert not has_no_systemd(EndedProcess(0, ""))


def test_a_last_line_is_safe_and_short() -> None:
    shown = last_line("a\n" + "\x1b]52;c;x\x07" + "b" * 10_000 + "\n")
    assert "\x1b" not in shown and len(shown) < 600
