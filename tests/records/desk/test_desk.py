"""Several consoles on one folder: presence, claims, answers to alarms, closed edges, notes."""

import fcntl
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import pytest

from fleet_tui.commands.rivals import rivals_text
from fleet_tui.config.schema import Config, DeskConfig, Operator
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.commands import CancelOrder, Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import (
    AlarmAcknowledged,
    AlarmShelved,
    AlarmUnshelved,
    EdgeClosed,
    EdgeOpened,
    RobotClaimed,
    RobotReleased,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Note
from fleet_tui.records.desk import desk as desk_module
from fleet_tui.records.desk import fact_file, outbox
from fleet_tui.records.desk.desk import AT_ONCE, SharedDesk, desk_of
from fleet_tui.records.desk.fact_file import FILE
from fleet_tui.state.store import Store
from tests.support.fleets import LINK, T0, commanded, fleet, link_lost, link_up
from tests.support.polling import HANGS, eventually
from tests.support.shared_desk import R3, DeskConsole, at_desk

EDGE = ends_of("floor_0", "2", "1")
ALARM = (LINK, "link")


def stage(state: FleetState) -> AlarmStage:
    """Return the stage of the one alarm."""
    return next((alarm.stage for alarm in state.alarms if alarm.key == ALARM), AlarmStage.CLEARED)


def count_lines(folder: Path) -> int:
    """Return the number of facts that were shared."""
    path = folder / FILE
    return len(path.read_bytes().splitlines()) if path.exists() else 0


def without_a_link(*consoles: DeskConsole) -> None:
    """Raise the same alarm on consoles."""
    for one in consoles:
        one.post(link_lost(T0))
        one.tick(T0 + 10)
        assert stage(one.state) is AlarmStage.UNACKNOWLEDGED


def test_consoles_see_each_other_their_robots_and_claims(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        ana.desk.selected = lambda: R3
        ana.post(RobotClaimed(R3))
        ben.becomes(lambda state: state.desk.other_holders(R3) == ["ana"])
        assert [(one.name, one.robot) for one in ben.state.desk.others] == [("ana", R3)]
        assert ana.state.desk.holders(R3) == ["ana"] and ana.state.desk.other_holders(R3) == []
        ana.post(RobotReleased(R3))
        ben.becomes(lambda state: not state.desk.holders(R3))
        ana.desk.close()
        ben.becomes(lambda state: state.desk.others == ())
    assert [path.name for path in tmp_path.iterdir() if path.name.startswith("console")] == []


def test_an_acknowledgement_counts_at_all_consoles_in_the_name_of_its_operator(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben", "cleo") as (ana, ben, cleo):
        without_a_link(ana, ben)
        ana.post(AlarmAcknowledged())
        ben.becomes(lambda state: stage(state) is AlarmStage.ACKNOWLEDGED)
        assert ben.state.desk.acted == "ana" and ana.state.desk.acted == ""
        without_a_link(cleo)  # a little later than the others
        cleo.becomes(lambda state: stage(state) is AlarmStage.ACKNOWLEDGED)
        # Nobody tells on what was told to it.
        assert count_lines(tmp_path) == 1


def test_shelving_counts_at_all_consoles_and_its_end_too(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        without_a_link(ana, ben)
        ana.post(AlarmShelved(*ALARM, T0 + 610))
        ben.becomes(lambda state: stage(state) is AlarmStage.SHELVED)
        (alarm,) = ben.state.alarms
        assert alarm.shelved_until == pytest.approx(T0 + 610)
        ben.post(AlarmUnshelved(*ALARM))
        ana.becomes(lambda state: stage(state) is AlarmStage.UNACKNOWLEDGED)


def test_a_console_that_has_just_come_adopts_what_was_answered(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana") as (ana,):
        without_a_link(ana)
        ana.post(AlarmAcknowledged(*ALARM))
        ana.post(EdgeClosed(EDGE, 5.0))
        ana.desk.share_note(Note(time.time(), "ana", "lift B is slow"))
        eventually(lambda: count_lines(tmp_path) == 3)
        ben = DeskConsole(tmp_path, "ben")
        ben.desk.start(ben.post)
        try:
            without_a_link(ben)
            ben.becomes(lambda state: stage(state) is AlarmStage.ACKNOWLEDGED)
            ben.becomes(lambda state: [edge.ends for edge in state.desk.closed] == [EDGE])
            assert ben.state.desk.closed[0].by == "ana"
            assert [(note.operator, note.text, new) for note, new in ben.notes] == [
                ("ana", "lift B is slow", False)
            ]
        finally:
            ben.desk.close()


def test_closed_edges_are_the_same_everywhere_whoever_was_faster(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben", "cleo") as consoles:
        ana, ben, cleo = consoles
        for turn in range(5):
            ana.post(EdgeClosed(EDGE, 1.0))
            ben.post(EdgeOpened(EDGE) if turn % 2 else EdgeClosed(EDGE, 2.0))
            ana.post(EdgeOpened(EDGE))
        end = ends_of("floor_1", "9", "8")
        cleo.post(EdgeClosed(end, 3.0))
        for one in consoles:
            one.becomes(lambda state: end in [edge.ends for edge in state.desk.closed])
        eventually(lambda: len({frozenset(e.ends for e in one.state.desk.closed) for one in consoles}) == 1)


def test_a_note_reaches_the_others_at_once(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        ana.desk.share_note(Note(time.time(), "ana", "robot_3 squeaks"))
        eventually(lambda: ben.notes)
        assert [(note.operator, note.text, is_new) for note, is_new in ben.notes] == [
            ("ana", "robot_3 squeaks", True)
        ]
        assert ana.notes == []


def test_many_facts_at_once_are_taken_in_parts_and_all_of_them(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        many = 3 * AT_ONCE
        for number in range(many):
            ana.desk.share_note(Note(time.time(), "ana", str(number)))
        eventually(lambda: len(ben.notes) == many)
        assert [note.text for note, _ in ben.notes] == [str(number) for number in range(many)]


def test_a_console_that_does_not_share_is_there_and_keeps_its_acts(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ben") as (ben,):
        ana = DeskConsole(tmp_path, "ana", shares=False)
        ana.desk.start(ana.post)
        try:
            ben.becomes(lambda state: [one.name for one in state.desk.others] == ["ana"])
            ana.post(EdgeClosed(EDGE, 1.0))
            ana.desk.share_note(Note(time.time(), "ana", "x"))
            ben.post(EdgeClosed(ends_of("floor_1", "1", "2"), 1.0))
            ana.becomes(lambda state: len(state.desk.closed) == 2)
            assert len(ben.state.desk.closed) == 1 and ben.notes == []
        finally:
            ana.desk.close()


KILLED = """
import sys, time
from pathlib import Path
from fleet_tui.model.desk.events import RobotClaimed
from tests.support.shared_desk import DeskConsole
one = DeskConsole(Path(sys.argv[1]), "ana")
one.desk.start(one.post)
one.post(RobotClaimed("robot_3"))
time.sleep(600)
"""


def test_the_claims_of_a_killed_console_end(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ben") as (ben,):
        process = subprocess.Popen([sys.executable, "-c", KILLED, str(tmp_path)])
        try:
            ben.becomes(lambda state: state.desk.holders(R3) == ["ana"], within=HANGS)
        finally:
            process.kill()
            process.wait()
        assert ben.becomes(lambda state: not state.desk.holders(R3)) < 10


def test_names_and_texts_of_others_can_not_write_to_the_terminal(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "\x1b]0;evil\x07" + "x" * 500) as (ana, _):
        (other,) = ana.state.desk.others
        assert "\x1b" not in other.name and len(other.name) <= desk_module.NAME


@pytest.mark.parametrize("content", [b"", b"garbage", b"[" * 100_000, b'{"id": "x"}', b"\xff" * 300_000])
def test_files_that_are_no_console_are_ignored_and_counted(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "console-x.json").write_bytes(content)
    (tmp_path / "console-link.json").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "console-pipe.json")
    (tmp_path / "console-folder.json").mkdir()
    with at_desk(tmp_path, "ana", "ben") as (ana, _):
        eventually(lambda: ana.desk.notes == ["desk: 4 entries ignored: not of a console"])


def test_a_folder_that_is_not_there_is_told_and_used_as_soon_as_it_is(tmp_path: Path) -> None:
    folder = tmp_path / "desk"
    ana = DeskConsole(folder, "ana")
    ana.desk.start(ana.post)
    try:
        ana.post(RobotClaimed(R3))
        eventually(lambda: ana.desk.notes == [f"desk: not shared: {folder}: No such file or directory"])
        ana.post(EdgeClosed(EDGE, 1.0))
        folder.mkdir()
        with at_desk(folder, "ben") as (ben,):
            ben.becomes(lambda state: state.desk.holders(R3) == ["ana"] if state.desk.others else False)
            ben.becomes(lambda state: [edge.ends for edge in state.desk.closed] == [EDGE])
        eventually(lambda: ana.desk.notes == [])
    finally:
        ana.desk.close()


def test_a_folder_that_does_not_respond_stops_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(desk_module, "SLOW", 0.1)
    with at_desk(tmp_path, "ana") as (ana,):
        hangs = os.open(tmp_path / "facts.lock", os.O_RDWR | os.O_CREAT)
        fcntl.flock(hangs, fcntl.LOCK_EX)
        ana.post(EdgeClosed(EDGE, 1.0))  # returns, although the lock stays
        assert len(ana.state.desk.closed) == 1
        eventually(lambda: ana.desk.notes == ["desk: not responding, nothing is shared"])
        os.close(hangs)
        eventually(lambda: ana.desk.notes == [])


def full(_path: Path, _content: bytes) -> None:
    raise OSError(28, "No space left on device")


def test_a_file_that_can_not_be_shortened_grows_by_each_fact_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fact_file, "LARGEST", 1)
    monkeypatch.setattr(desk_module, "EVERY", 0.001)
    monkeypatch.setattr(fact_file, "replace_shared", full)
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        ana.desk.share_note(Note(time.time(), "ana", "one"))
        ben.desk.share_note(Note(time.time(), "ben", "two"))
        eventually(lambda: ana.notes and ben.notes)
        for number in range(50):  # each is seen after some more looks of ana
            ben.desk.selected = lambda robot=f"robot_{number % 5}": robot  # type: ignore[misc]  # typed by its default
            ana.becomes(lambda state, at=number: state.desk.others[0].robot == f"robot_{at % 5}")  # type: ignore[misc]  # as above
        assert count_lines(tmp_path) == 2
        (note,) = ana.desk.notes
        assert note == "desk: facts.jsonl grows, it can't be shortened: No space left on device"


def test_answers_that_waited_for_the_folder_are_shared_while_they_are_so(tmp_path: Path) -> None:
    """Nobody has seen an alarm that came again since."""
    folder = tmp_path / "desk"
    ana = DeskConsole(folder, "ana")
    ana.desk.start(ana.post)
    try:
        without_a_link(ana)
        ana.post(AlarmAcknowledged(*ALARM))
        ana.post(link_up(T0 + 20))
        ana.tick(T0 + 100)
        ana.post(link_lost(T0 + 100))
        ana.tick(T0 + 110)
        assert stage(ana.state) is AlarmStage.UNACKNOWLEDGED
        folder.mkdir()
        with at_desk(folder, "ben") as (ben,):
            without_a_link(ben)
            ana.post(EdgeClosed(EDGE, 1.0))
            ben.becomes(lambda state: state.desk.closed)
            assert stage(ben.state) is AlarmStage.UNACKNOWLEDGED
            assert count_lines(folder) == 1
    finally:
        ana.desk.close()


def test_a_shelving_that_waited_for_the_folder_lasts_as_long_as_there(tmp_path: Path) -> None:
    folder = tmp_path / "desk"
    with_ben = DeskConsole(folder, "ben")
    ana = DeskConsole(folder, "ana")
    for one in (ana, with_ben):
        one.desk.start(one.post)
    try:
        without_a_link(ana, with_ben)
        ana.post(AlarmShelved(*ALARM, T0 + 610))
        ana.tick(T0 + 510)
        folder.mkdir()
        with_ben.becomes(lambda state: stage(state) is AlarmStage.SHELVED)
        (alarm,) = with_ben.state.alarms
        assert alarm.shelved_until - with_ben.state.now <= 120  # to the minute, by the presence of ana
    finally:
        ana.desk.close()
        with_ben.desk.close()


def test_what_waits_is_limited_and_the_loss_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outbox, "WAITING", 2)
    ana = DeskConsole(tmp_path / "gone", "ana")
    ana.desk.start(ana.post)
    try:
        for number in range(5):
            ana.desk.share_note(Note(float(number), "ana", str(number)))
        assert "desk: 3 facts not shared" in ana.desk.notes
    finally:
        ana.desk.close()


def test_twenty_consoles_on_one_folder(tmp_path: Path) -> None:
    with at_desk(tmp_path, *(f"user_{n}" for n in range(20))) as consoles:
        without_a_link(*consoles)
        consoles[0].post(AlarmAcknowledged(*ALARM))
        consoles[7].post(RobotClaimed(R3))
        for one in consoles:
            one.becomes(lambda state: stage(state) is AlarmStage.ACKNOWLEDGED)
            one.becomes(lambda state: state.desk.holders(R3) == ["user_7"])


def test_without_a_desk_there_is_none_and_read_only_shares_nothing(tmp_path: Path) -> None:
    with desk_of(Config(), Store(fleet()), "ana") as none:
        assert none is None
    config = Config(desk=DeskConfig("d"), operator=Operator(read_only=True), path=tmp_path / "config.toml")
    with desk_of(config, Store(fleet()), "ana") as made:
        assert isinstance(made, SharedDesk)
        made.share_note(Note(0.0, "ana", "x"))
        assert made.notes == []


def test_a_cancel_or_clear_is_known_at_the_others_with_its_author(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        for fact in commanded(7, CancelOrder(R3, "5"), Stage.SENT, Stage.REFUSED):
            ana.post(fact)
        ben.becomes(lambda state: [one.stage for one in state.desk.elsewhere] == [Stage.REFUSED])
        (removal,) = ben.state.desk.elsewhere
        assert (removal.robot, removal.order_id) == (R3, "5") and removal.text.startswith(
            "cancelled by ana at "
        )
        assert ana.state.desk.elsewhere == ()


def test_two_who_command_a_robot_at_once_see_who_else_did(tmp_path: Path) -> None:
    with at_desk(tmp_path, "ana", "ben") as (ana, ben):
        now = time.monotonic()
        given: list[tuple[DeskConsole, Command]] = [(ana, PauseRobot(R3)), (ben, ResumeRobot(R3))]
        for one, command in given:
            one.tick(now)
            for step in commanded(7, command, Stage.SENT, at=now):
                one.post(step)
        ana.becomes(lambda state: rivals_text(state, R3))
        ben.becomes(lambda state: rivals_text(state, R3))
        assert re.fullmatch(r"ben at \S+:\d+: resume", rivals_text(ana.state, R3))
        assert re.fullmatch(r"ana at \S+:\d+: pause", rivals_text(ben.state, R3))
