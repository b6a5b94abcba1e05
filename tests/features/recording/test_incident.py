"""One key packs an incident: one at a time, and whatever goes wrong is said."""

from collections.abc import Callable
from pathlib import Path

from fleet_tui.features.recording.incident import Cancelled, IncidentPacking
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.desk import Desk, ready

Threads = list[Callable[[Cancelled], None]]


def packing(pack: Callable[[str, Cancelled], Path] | None) -> tuple[list[str], Threads, IncidentPacking]:
    desk, threads = Desk(ready()), Threads()
    console = desk.console(ConsoleFiles(pack=pack))
    return desk.said, threads, IncidentPacking(console, lambda: "<svg/>", threads.append)


def test_it_says_what_it_packed_and_where(tmp_path: Path) -> None:
    def pack(shot: str, _is_cancelled: Cancelled) -> Path:
        (tmp_path / "a.zip").write_text(shot * 250)
        return tmp_path / "a.zip"

    said, threads, incident = packing(pack)
    incident.pack()
    incident.pack()
    assert said[1] == "still packing: the doctor takes up to 10 s" and len(threads) == 1
    threads[0](lambda: False)
    assert said[2] == f"packed 1.5 kB: {tmp_path / 'a.zip'}"
    incident.pack()
    assert len(threads) == 2


def test_whatever_goes_wrong_is_said_and_may_be_tried_again() -> None:
    def pack(_shot: str, _is_cancelled: Cancelled) -> Path:
        raise ZeroDivisionError("no disk")

    said, threads, incident = packing(pack)
    incident.pack()
    threads[0](lambda: False)
    assert said[-1] == "incident not packed: no disk"
    incident.pack()
    assert len(threads) == 2


def test_a_console_that_ends_says_nothing_any_more(tmp_path: Path) -> None:
    (tmp_path / "a.zip").touch()
    said, threads, incident = packing(lambda _shot, _is_cancelled: tmp_path / "a.zip")
    incident.pack()
    threads[0](lambda: True)
    assert len(said) == 1


def test_where_there_is_nothing_to_pack_it_says_so() -> None:
    said, threads, incident = packing(None)
    incident.pack()
    assert said == ["nothing to pack: not a live console"] and not threads
