"""A routine that runs: orders and programs of several robots, without a wire."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.features.routines.files import read_routine
from fleet_tui.features.routines.lane import (
    Gate,
    Lane,
    LaneNote,
    LanePhase,
    LaneResumed,
    LaneStopped,
    OrderEnded,
    OrderWithheld,
    Position,
)
from fleet_tui.features.routines.progress import RoutineProgress
from fleet_tui.features.routines.run import RoutineRun, RunParts
from fleet_tui.model.commands import PlaceOrder, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.request import Request
from fleet_tui.state.store import Store
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import Message
from tests.support.fleets import R0, T0, commanded, link_lost, link_up, queue, tick
from tests.support.polling import eventually
from tests.support.routines import two_robots

TWO = "for robot_0\ncarry Base Consumidores\nwait until idle\nend\nfor robot_1\nrun check\nend\n"


class Desk:
    """A run with everything that it sent, said and saved."""

    def __init__(self, folder: Path, text: str, before: RoutineProgress | None = None) -> None:
        (folder / "day.routine").write_text(text)
        (folder / "check").write_text("#!/bin/sh\nexec cat fifo\n")
        (folder / "check").chmod(0o700)
        self.store = Store(two_robots())
        self.sent = list[PlaceOrder]()
        self.notes = list[tuple[str, LaneNote]]()
        self.log = list[str]()
        self.saved = list[RoutineProgress]()
        self.kept_at_sending = list[LanePhase]()
        self.objection: OrderEnded | OrderWithheld | None = None
        parts = RunParts(
            self.store,
            self._give,
            lambda robot, note: self.notes.append((robot, note)),
            lambda change, words: self.log.append(f"{change}: {words}"),
            self.saved.append,
        )
        self.run = RoutineRun(read_routine(folder, "day"), parts, "ana", before)

    def _give(self, request: Request) -> OrderEnded | OrderWithheld | None:
        (order,) = request.commands
        assert isinstance(order, PlaceOrder)
        if self.objection is None:
            self.kept_at_sending.append(self.saved[-1].lanes[0].phase)
            self.sent.append(order)
        return self.objection

    def after(self, *events: Event) -> Lane:
        for event in events:
            self.store.apply(event)
        self.run.tick()
        return next(iter(self.run.lanes.values()))

    def accepted(self) -> tuple[Event, ...]:
        """The first order, seen in the queue as order 4."""
        sent = commanded(1, self.sent[0], Stage.SENT, Stage.ACCEPTED)
        return *sent, queue(T0 + 1, (4, 1, 2, "Q")), tick(T0 + 1)


def test_an_order_counts_once_it_was_driven(tmp_path: Path) -> None:
    desk = Desk(tmp_path, "for robot_0\ncarry Base Consumidores\nend\n")
    assert desk.after().phase is LanePhase.ORDERED
    assert [stop.vertex for stop in desk.sent[0].stops] == ["1", "2"]
    listed = desk.after(*desk.accepted())
    assert listed.phase is LanePhase.ORDERED and desk.saved[-1].lanes[0].order_id == "4"
    assert desk.after(*commanded(1, desk.sent[0], Stage.DONE)[1:]).phase is LanePhase.DONE
    assert desk.run.is_over and len(desk.sent) == 1
    assert desk.log == ["routine started: day: robot_0", "routine done: day robot_0"]


def test_an_order_is_kept_as_sent_before_it_is_sent(tmp_path: Path) -> None:
    desk = Desk(tmp_path, "for robot_0\nwait 0 s\ncarry Base Consumidores\nend\n")
    while not desk.sent:
        desk.after()
    assert desk.kept_at_sending == [LanePhase.ORDERED], "a crash just then must not give it twice"


def test_a_lost_link_holds_it_and_a_person_resumes(tmp_path: Path) -> None:
    desk = Desk(tmp_path, "for robot_0\ncarry Base Consumidores\ngo 'Packing area'\nend\n")
    desk.after()
    held = desk.after(*desk.accepted(), link_lost(T0 + 1))
    assert held.gate is Gate.HELD and held.phase is LanePhase.ORDERED
    assert desk.run.no_link(R0) and "connection refused" in held.detail
    assert any(line.startswith("routine held: day robot_0: ") for line in desk.log)
    desk.after(link_up(T0 + 9), *commanded(1, desk.sent[0], Stage.DONE)[1:])
    assert desk.after().phase is LanePhase.READY and len(desk.sent) == 1, "nothing follows by itself"
    desk.run.request(LaneResumed(), R0)
    desk.after()
    assert len(desk.sent) == 2 and desk.run.no_link(R0) == ""


@pytest.mark.parametrize(
    ("objection", "phase", "gate"),
    [
        (OrderWithheld(Message("robot_0 is paused")), LanePhase.READY, Gate.HELD),
        (OrderEnded(False, Message("no path")), LanePhase.FAILED, Gate.OPEN),
    ],
)
def test_an_order_that_may_not_be_sent(
    tmp_path: Path, objection: OrderEnded | OrderWithheld, phase: LanePhase, gate: Gate
) -> None:
    desk = Desk(tmp_path, "for robot_0\ncarry Base Consumidores\nend\n")
    desk.objection = objection
    lane = desk.after()
    assert (lane.phase, lane.gate, lane.detail) == (phase, gate, objection.words)


def test_a_robot_that_is_there_already_needs_no_order(tmp_path: Path) -> None:
    desk = Desk(tmp_path, "for robot_0\ngo Base\nend\n")
    assert desk.after().phase is LanePhase.READY and desk.sent == []
    assert Desk(tmp_path, "for robot_0\ngo Nowhere\nend\n").after().detail.startswith("robot_0 has no place")


def test_a_program_is_ended_by_a_stop_and_an_order_is_not(tmp_path: Path, fifo: Callable[[], None]) -> None:
    desk = Desk(tmp_path, TWO)
    desk.after()
    assert {lane.phase for lane in desk.run.lanes.values()} == {LanePhase.ORDERED, LanePhase.PROGRAM}
    desk.run.request(LaneStopped())
    desk.run.close()
    assert desk.run.is_over and desk.saved[-1].is_over and len(desk.sent) == 1
    assert "routine program: day robot_1: run check" in desk.log


def test_a_program_that_succeeds_ends_its_instruction(tmp_path: Path, fifo: Callable[[], None]) -> None:
    desk = Desk(tmp_path, "for robot_1\nrun check\nend\n")
    desk.after()
    fifo()
    eventually(lambda: desk.after() and desk.run.is_over)
    assert desk.run.lanes["robot_1"].phase is LanePhase.DONE


def test_an_order_of_an_earlier_process_is_followed(tmp_path: Path) -> None:
    before = Desk(tmp_path, "for robot_0\ncarry Base Consumidores\nend\n")
    before.after()
    before.after(*before.accepted())
    desk = Desk(tmp_path, "for robot_0\ncarry Base Consumidores\nend\n", before.saved[-1])
    assert desk.after(queue(T0 + 1, (4, 1, 2, "I"), current=4)).phase is LanePhase.ORDERED
    desk.run.request(LaneResumed())
    assert desk.after().phase is LanePhase.ORDERED and desk.sent == [], "it is not given a second time"
    assert desk.log[0] == "routine resumed: day: robot_0"


def test_a_progress_that_fits_no_line_is_refused(tmp_path: Path) -> None:
    before = Desk(tmp_path, "for robot_0\ngo Base\nend\n").saved[-1]
    astray = Lane("robot_0", (Position(index=3), Position()))
    with pytest.raises(RoutineError, match="does not match the file: start it again"):
        Desk(tmp_path, "for robot_0\ngo Base\nend\n", replace(before, lanes=(astray,)))


@pytest.fixture
def fifo(tmp_path: Path) -> Callable[[], None]:
    """The program runs until this is called."""
    os.mkfifo(tmp_path / "fifo")

    def release() -> None:
        (tmp_path / "fifo").write_text("released\n")

    return release
