"""Findings as lines: within the terminal, and moving no cursor."""

from dataclasses import replace

from fleet_tui.features.doctor.render import line, summary
from fleet_tui.links.discovery.finding import Finding, Verdict

LONG = Finding(
    "robot_0",
    "queue",
    Verdict.FAIL,
    "/robot_0/queue is not on the bridge",
    'did you mean /robot_0/action_queue? Set [profile.topics] queue = "/{robot}/action_queue"',
)


def test_80_columns() -> None:
    assert line(LONG, plain=False, colour=False, width=80).splitlines() == [
        "   FAIL ✗ robot_0 queue: /robot_0/queue is not on the bridge -> did you mean",
        "          /robot_0/action_queue? Set [profile.topics] queue =",
        '          "/{robot}/action_queue"',
    ]
    assert "\n" not in line(LONG, plain=False, colour=False)


def test_text_of_the_wire_moves_no_cursor() -> None:
    hostile = replace(LONG, measured="\x1b[2J\u202eboo")
    assert "\x1b" not in line(hostile, plain=False, colour=False)
    assert line(hostile, plain=True, colour=False).isascii()
    assert "\x1b" not in summary([hostile])


def test_the_last_line_names_the_fault_to_begin_with_or_else_the_warnings() -> None:
    """A hundred lines that are ok may stand between them and the last line."""
    well, unclear = replace(LONG, verdict=Verdict.OK), replace(LONG, check="charge", verdict=Verdict.WARN)
    assert summary([unclear, well, well]) == "2 ok, 1 warn: robot_0 charge"
    assert summary([unclear, LONG]).startswith("1 warn, 1 FAIL. Start with robot_0 queue: ")
    assert summary([well]) == "1 ok"
