"""Lines of the audit log on commands, alarms and the console, and their times."""

import gc
import os
import re
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Config, Operator
from fleet_tui.model.alarm import Alarm, Condition, Priority
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import CommandAdvanced, CommandIssued
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit import log as module
from fleet_tui.records.audit.entries import TEXT_KEPT, Origin
from fleet_tui.records.audit.file import FILE_NAME, KEPT, MAX_BYTES, audit_file
from fleet_tui.records.audit.log import Audit, auditing, encode, operator_name
from fleet_tui.state.store import Store
from fleet_tui.storage.line_file import LineFile
from fleet_tui.text.language import Message
from tests.support.fleets import F0, R0, T0, WALL, tick
from tests.support.records import ANA, ORDER, give, known_fleet, read, record, watched
from tests.support.watched_store import config_of


def held_states() -> dict[int, FleetState]:
    """Those of the times of this test: a link that another one left may have made others meanwhile."""
    gc.collect()
    states = [one for one in gc.get_objects() if isinstance(one, FleetState)]
    return {id(one): one for one in states if T0 <= one.now < T0 + 60}


def test_no_state_is_kept_once_its_lines_are_written(tmp_path: Path) -> None:
    store, _ = watched(tmp_path)
    give(store, 7, ORDER, Stage.SENT)
    before = held_states()  # and held here: those of other tests may go meanwhile
    for second in range(1, 6):
        store.apply(tick(T0 + second))
    assert held_states().keys() - before.keys() == {id(store.state)}


def test_the_line_is_there_before_anything_else_happens(tmp_path: Path) -> None:
    """In the link the command is sent after it was told."""
    store, _ = watched(tmp_path)
    store.apply(CommandIssued(1, ORDER, T0, WALL))
    assert [one.change for one in read(tmp_path)] == ["checked"]


def test_the_console_itself_and_what_it_leaves_open(tmp_path: Path) -> None:
    config = config_of("ws://site:9090")
    store = Store(known_fleet())
    with auditing(tmp_path, config, store, demo=True):
        give(store, 1, ORDER, Stage.SENT)
        give(store, 2, ORDER, Stage.NOT_SENT)
    store.apply(CommandAdvanced(1, Stage.UNKNOWN, T0))
    found = read(tmp_path)
    assert (found[0].kind, found[0].change) == ("console", "opened")
    assert [(one.id, one.change, one.words) for one in found[-2:]] == [
        (1, "console closed", "last stage: sent"),
        (None, "closed", ""),
    ]
    assert all(one.demo for one in found)
    assert len({one.run for one in found}) == 1


class BadDisk(LineFile):
    """Refuses as long as it is `full`, keeps who writes while it `answers` not, and takes its time for each
    line."""

    full = False
    seconds = 0.0

    def __init__(self, path: Path) -> None:
        super().__init__(path, MAX_BYTES, KEPT)
        self.answers = threading.Event()
        self.answers.set()

    def append(self, line: bytes) -> None:
        self.answers.wait(20)
        time.sleep(self.seconds)
        if self.full:
            raise OSError(28, "No space left on device")
        super().append(line)


@pytest.fixture
def disk(tmp_path: Path) -> BadDisk:
    return BadDisk(tmp_path / FILE_NAME)


def lines(disk: BadDisk) -> list[bytes]:
    """The whole lines so far: the last one may be half written while this looks."""
    return disk.path.read_bytes().split(b"\n")[:-1] if disk.path.exists() else []


def becomes(holds: Callable[[], object]) -> None:
    """Wait for the log's own thread."""
    end = time.monotonic() + 10
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.002)


def test_a_full_disk_is_said_and_what_was_not_written_is_written_later(tmp_path: Path, disk: BadDisk) -> None:
    disk.full = True
    store, audit = Store(known_fleet()), Audit(disk, ANA)
    store.watchers.append(audit.watch)
    give(store, 1, ORDER, Stage.SENT, Stage.REFUSED)
    assert store.state.commands[0].stage is Stage.REFUSED
    assert audit.notes == ["audit: not written: No space left on device"]
    disk.full = False
    becomes(lambda: audit.notes == [])
    give(store, 2, ORDER)
    assert [(one.id, one.change) for one in read(tmp_path)] == [
        *((1, change) for change in ("checked", "sent", "refused")),
        (2, "checked"),
    ]


def test_a_disk_is_not_tried_at_every_record(tmp_path: Path, disk: BadDisk) -> None:
    disk.full = True
    audit = Audit(disk, ANA)
    audit.log_console("one")
    disk.full = False
    audit.log_console("two")
    assert audit.notes != [] and not (tmp_path / FILE_NAME).exists()
    assert audit.close(known_fleet()) == 0  # the last chance is taken
    assert [one.change for one in read(tmp_path)] == ["one", "two", "closed"]


def test_a_slow_disk_has_the_end_of_every_command(tmp_path: Path, disk: BadDisk) -> None:
    disk.seconds = 0.05
    store, audit = Store(known_fleet()), Audit(disk, ANA)
    store.watchers.append(audit.watch)
    for n in range(1, 11):
        give(store, n, ORDER)
    assert audit.close(store.state) == 0
    found = read(tmp_path)
    assert [one.id for one in found if one.change == "console closed"] == [*range(1, 11)]


def test_a_stage_that_only_the_state_has_at_the_end_is_written(tmp_path: Path) -> None:
    """Who waits for a stage sees it before the log's watcher does, and may end the console by it."""
    store, audit = Store(known_fleet()), Audit(audit_file(tmp_path / FILE_NAME), ANA)
    store.watchers.append(audit.watch)
    give(store, 1, ORDER, Stage.SENT)
    store.watchers.clear()
    store.apply(CommandAdvanced(1, Stage.REFUSED, store.state.now, Message("no")))
    assert audit.close(store.state) == 0
    assert [one.change for one in read(tmp_path)][-2:] == ["refused", "closed"]


def test_what_waits_has_a_bound_and_what_is_lost_is_counted(
    tmp_path: Path, disk: BadDisk, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "WAITING", 10)
    disk.full = True
    audit = Audit(disk, ANA)
    for n in range(25):
        audit.log_console(f"n{n}")
    disk.full = False
    assert audit.close(known_fleet()) == 0
    found = read(tmp_path)
    assert [one.change for one in found] == [*(f"n{n}" for n in range(16, 25)), "closed", "lost"]
    assert found[-1].words == "16 records before this one were not written"


def test_a_disk_that_does_not_answer_holds_nobody(tmp_path: Path, disk: BadDisk) -> None:
    """A network's file system: who commands waits a moment, once; the lines wait for the disk."""
    store, audit = Store(known_fleet()), Audit(disk, ANA)
    store.watchers.append(audit.watch)
    give(store, 1, ORDER, Stage.SENT)
    becomes(lambda: len(lines(disk)) == 2)
    disk.answers.clear()
    for n in range(2, 102):
        give(store, n, ORDER, Stage.SENT)
    assert len(lines(disk)) == 2  # the next line is still with the disk
    assert store.state.commands[-1].stage is Stage.SENT
    assert audit.notes == ["audit: not written: disk not responding"]
    disk.answers.set()
    becomes(lambda: audit.notes == [] and len(lines(disk)) == 202)
    assert [one.id for one in read(tmp_path)] == [n for n in range(1, 102) for _ in range(2)]


def test_a_slow_disk_holds_nobody_for_long(
    tmp_path: Path, disk: BadDisk, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each line takes less than would be said: after the first no alarm waits for a while."""

    def append(line: bytes) -> None:
        time.sleep(0.03)  # the slowness itself
        LineFile.append(disk, line)

    monkeypatch.setattr(disk, "append", append)
    audit, quiet = Audit(disk, ANA), known_fleet()
    for n in range(100):
        condition = Condition(R0, f"kind {n}", Priority.LOW, Message("text"), Message("over"))
        audit.watch(quiet, replace(quiet, alarms=(Alarm(condition, WALL, WALL, T0),)))
    assert len(lines(disk)) < 100  # else it would have waited for each
    becomes(lambda: len(lines(disk)) == 100)


def test_a_command_waits_for_a_slow_disk(tmp_path: Path, disk: BadDisk) -> None:
    """However slow it was before: it is sent after its line is written."""
    disk.seconds = 0.03
    store, audit = Store(known_fleet()), Audit(disk, ANA)
    store.watchers.append(audit.watch)
    for n in range(1, 21):
        store.apply(CommandIssued(n, ORDER, T0, WALL))
        assert [one.id for one in read(tmp_path)] == [*range(1, n + 1)]
    assert audit.notes == []


@pytest.mark.parametrize("starved", ["before", "within"])
def test_a_busy_machine_is_no_disk_that_hangs(
    tmp_path: Path, disk: BadDisk, monkeypatch: pytest.MonkeyPatch, starved: str
) -> None:
    """The writing thread gets no processor: before it has the line, or while it writes."""
    store, audit = Store(known_fleet()), Audit(disk, ANA)
    store.watchers.append(audit.watch)
    next_line, append = audit._next, disk.append

    def late() -> bytes | None:
        time.sleep(4 * module.PATIENCE)
        return next_line()

    def busy(line: bytes) -> None:
        end = time.thread_time() + 4 * module.PATIENCE
        while time.thread_time() < end:
            pass
        append(line)

    if starved == "before":
        monkeypatch.setattr(audit, "_next", late)
        give(store, 1, ORDER)  # the thread was waiting already
    else:
        monkeypatch.setattr(disk, "append", busy)
    give(store, 2, ORDER)
    assert read(tmp_path)[-1].id == 2
    assert audit.notes == []


def test_one_slow_line_leaves_no_command_before_its_own(
    tmp_path: Path, disk: BadDisk, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The disk is well, only the machine was busy for a moment."""

    def slowly(line: bytes) -> None:
        time.sleep(0.03)  # the slowness itself
        LineFile.append(disk, line)

    audit = Audit(disk, ANA)
    with monkeypatch.context() as patched:
        patched.setattr(disk, "append", slowly)
        audit.log_console("slow")
    for n in range(20):
        audit.log_console(f"n{n}")
        assert read(tmp_path)[-1].change == f"n{n}"


@pytest.mark.parametrize(("hangs", "says"), [(False, "No space left on device"), (True, module.HANGS)])
def test_what_is_lost_for_good_is_said_at_the_end(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    hangs: bool,
    says: str,
) -> None:
    disk = BadDisk(tmp_path / FILE_NAME)
    disk.full = not hangs
    monkeypatch.setattr(module, "audit_file", lambda _path: disk)
    store = Store(known_fleet())
    with auditing(tmp_path, config_of("ws://site:9090"), store):
        if hangs:
            disk.answers.clear()
        give(store, 1, ORDER, Stage.NOT_SENT)
    disk.answers.set()
    lost = 3 if hangs else 4  # who opened it was written before it hung
    assert capsys.readouterr().err == f"audit: {lost} records not written: {says}\n"


def _no_folder(folder: Path) -> Path:
    (folder / "file").write_text("")
    return folder / "file" / "state"


def _device(folder: Path) -> Path:
    (folder / FILE_NAME).symlink_to("/dev/full")
    return folder


def _pipe(folder: Path) -> Path:
    """It would take lines for nobody to read."""
    os.mkfifo(folder / FILE_NAME)
    return folder


@pytest.mark.parametrize(
    ("prepare", "says"),
    [(_no_folder, "Not a directory"), (_device, "not a regular file"), (_pipe, "not a regular file")],
)
def test_what_the_disk_says_stands_on_the_screen(
    tmp_path: Path, prepare: Callable[[Path], Path], says: str
) -> None:
    store, audit = watched(prepare(tmp_path))
    give(store, 1, ORDER, Stage.SENT)
    assert audit.notes == [f"audit: not written: {says}"]
    assert audit.close(store.state) > 0


def test_an_error_of_our_own_stops_no_dispatch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store, _ = watched(tmp_path)

    def broken(_record: object) -> bytes:
        raise RuntimeError

    with monkeypatch.context() as patched:
        patched.setattr(module, "encode", broken)
        give(store, 1, ORDER, Stage.SENT)
    give(store, 2, ORDER)
    assert [one.change for one in read(tmp_path)] == ["checked", "lost"]


def test_an_error_of_our_own_does_not_end_the_writing(
    tmp_path: Path, disk: BadDisk, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patched:
        patched.setattr(disk, "append", lambda _line: 1 / 0)
        audit = Audit(disk, ANA)
        audit.log_console("one")
        assert audit.notes == ["audit: not written: ZeroDivisionError('division by zero')"]
    becomes(lambda: audit.notes == [])
    assert [one.change for one in read(tmp_path)] == ["one"]


HOSTILE = "\x1b[2J\x9b31m\u202eevil\x07\r\n\ud800\x00[red]" + "é" * 2000


def test_hostile_words_stay_what_they_are_and_act_on_nobody(tmp_path: Path) -> None:
    store, _ = watched(tmp_path, Origin(HOSTILE, HOSTILE, "run"))
    give(store, 1, ORDER, Stage.SENT, Stage.REFUSED, detail=HOSTILE)
    raw = (tmp_path / FILE_NAME).read_bytes()
    assert len(raw.splitlines()) == 3 and len(raw) < 3 * 40 * TEXT_KEPT
    assert all(0x20 <= byte < 0x7F or byte == 0x0A for byte in raw)
    found = read(tmp_path)
    assert found[-1].words.startswith("\x1b[2J\x9b31m\u202eevil\x07\r\n\\ud800\x00[red]é")
    assert found[-1].words.endswith(f"… ({len(HOSTILE):,} characters)")


def test_the_operator_is_named_by_the_config_or_the_login(monkeypatch: pytest.MonkeyPatch) -> None:
    assert operator_name(Config(operator=Operator("eva"))) == "eva"
    monkeypatch.setenv("LOGNAME", "ben")
    assert operator_name(Config()) == "ben"

    def nobody() -> str:
        raise KeyError("uid not found")

    monkeypatch.setattr("getpass.getuser", nobody)
    assert re.fullmatch(r"uid \d+", operator_name(Config()))


def test_a_record_reads_back_as_it_was() -> None:
    import msgspec

    from fleet_tui.model.audit_record import AuditRecord

    whole = record(
        "w", id=1, start="2", end="3", start_label="é", order="4", floor=F0, priority="low", count=5
    )
    assert msgspec.json.decode(encode(whole), type=AuditRecord) == whole
