"""The doctor's judgement of the terminal: size, colours, glyphs, speed."""

import os
import pty
import threading

import pytest

from fleet_tui.features.doctor.terminal import (
    BRAILLE,
    NOTHING,
    colour_finding,
    locale_finding,
    measured_findings,
    size_finding,
    speed_finding,
)
from fleet_tui.links.discovery.finding import Finding, Verdict


@pytest.mark.parametrize(
    ("finding", "verdict"),
    [
        (size_finding(120, 40), Verdict.OK),
        (size_finding(59, 40), Verdict.WARN),
        (colour_finding({"TERM": "xterm-256color"}), Verdict.OK),
        (colour_finding({"TERM": "dumb"}), Verdict.WARN),
        (colour_finding({"TERM": "dumb", "NO_COLOR": "1"}), Verdict.OK),
        (locale_finding("UTF-8", "C.UTF-8"), Verdict.OK),
        (locale_finding("ANSI_X3.4-1968", "C"), Verdict.WARN),
        (speed_finding(9_600 / 10, 0.1), Verdict.WARN),
    ],
)
def test_the_terminal(finding: Finding, verdict: Verdict) -> None:
    assert finding.verdict is verdict
    assert bool(finding.remedy) == (verdict is Verdict.WARN)


@pytest.mark.parametrize(("wide", "verdict"), [(1, Verdict.OK), (2, Verdict.WARN)])
def test_a_terminal_that_answers_is_measured(wide: int, verdict: Verdict) -> None:
    theirs, ours = pty.openpty()

    def answer() -> None:
        """A terminal: asked four times, it says where its cursor is; braille may take two cells each."""
        received, asked = b"", 0
        while asked < 4:
            received += os.read(theirs, 65536)
            while b"\x1b[6n" in received and asked < 4:
                before, _, received = received.partition(b"\x1b[6n")
                column = 1 + wide * before.decode().count(BRAILLE[0])
                os.write(theirs, f"\x1b[1;{column}R".encode())
                asked += 1

    terminal = threading.Thread(target=answer, daemon=True)
    terminal.start()
    glyphs, speed = measured_findings(ours, ours)
    terminal.join(5)
    assert glyphs.verdict is verdict and glyphs.values["cells"] == wide * len(BRAILLE)
    assert speed.check == "speed" and len(NOTHING) > 10_000
    os.close(ours)
    os.close(theirs)


def test_a_terminal_that_does_not_answer_is_skipped() -> None:
    theirs, ours = pty.openpty()
    assert [one.verdict for one in measured_findings(ours, ours)] == [Verdict.SKIPPED] * 2
    os.close(ours)
    os.close(theirs)
