"""Records of commands and alarms: each step, with its robot, its place and its link."""

import json
from datetime import datetime
from itertools import pairwise
from pathlib import Path

import pytest

from fleet_tui.config.start import initial_state
from fleet_tui.model.audit_record import VERSION
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.desk.events import AlarmAcknowledged
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.order import at_vertices
from fleet_tui.records.audit.entries import alarm_records, command_records
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from tests.support.fleets import (
    F0,
    R0,
    T0,
    battery,
    commanded,
    fleet,
    link_lost,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)
from tests.support.records import ANA, ORDER, give, read, watched
from tests.support.watched_store import config_of


def test_a_command_from_the_key_to_its_end(tmp_path: Path) -> None:
    store, _ = watched(tmp_path)
    give(store, 7, ORDER, Stage.SENT, Stage.ACCEPTED)
    store.apply(tick(T0 + 1))
    store.apply(queue(T0 + 1, (12, 1, 2, "Q")))
    store.apply(tick(T0 + 2))
    found = read(tmp_path)
    assert [one.change for one in found] == [
        "checked",
        "sent",
        "accepted",
    ]  # queue unknown before the command
    for one in found:
        assert (one.id, one.kind, one.what, one.robot, one.floor) == (7, "command", "order", R0, F0)
        assert (one.start, one.start_label, one.end, one.end_label) == ("1", "Base", "2", "")
        assert (one.operator, one.console, one.run, one.version) == ("ana", "host:1", "run1", VERSION)
        assert (one.link, one.url) == ("rosbridge", "ws://site:9090")
        assert datetime.fromisoformat(one.time).utcoffset() is not None


def test_the_order_that_was_recognised_and_the_robots_words_are_in_it(tmp_path: Path) -> None:
    store, _ = watched(tmp_path)
    store.apply(queue(T0))
    give(store, 7, ORDER, Stage.SENT, Stage.ACCEPTED, detail="ACCEPTED")
    store.apply(queue(T0 + 1, (12, 1, 2, "Q")))
    store.apply(tick(T0 + 2))
    last = read(tmp_path)[-1]
    assert (last.change, last.order, last.words) == ("confirmed", "12", "seen in the queue as order 12")
    assert read(tmp_path)[-2].words == "ACCEPTED"


@pytest.mark.parametrize(
    ("command", "what", "arguments"),
    [
        (place_order(R0, 3), "bring cargo", {"end": "3", "end_label": "Store"}),
        (CancelOrder(R0, "12"), "cancel", {"order": "12"}),
        (PlaceOrder(R0, at_vertices("2"), to_any=True), "order any", {"end": "2"}),
        (ClearOrders(R0), "clear", {}),
        (PauseRobot(R0), "pause", {}),
        (ResumeRobot(R0), "resume", {}),
    ],
)
def test_every_kind_of_command(
    tmp_path: Path, command: Command, what: str, arguments: dict[str, object]
) -> None:
    store, _ = watched(tmp_path)
    give(store, 1, command, Stage.NOT_SENT, detail="no link")
    line = json.loads((tmp_path / FILE_NAME).read_bytes().splitlines()[-1])
    asked = "start", "start_label", "end", "end_label", "order"
    known = {name: line.get(name) for name in asked}
    assert {name: value for name, value in known.items() if value is not None} == arguments
    assert (line["what"], line["change"], line["words"]) == (what, "not sent", "no link")


def test_an_alarm_from_raised_to_cleared(tmp_path: Path) -> None:
    store, _ = watched(tmp_path)
    for fact in (battery(T0 + 1, 15.0), tick(T0 + 1), tick(T0 + 1.1), AlarmAcknowledged()):
        store.apply(fact)
    store.apply(pose(T0 + 59))
    for fact in (battery(T0 + 2, 80.0), tick(T0 + 2), battery(T0 + 60), tick(T0 + 60)):
        store.apply(fact)
    found = read(tmp_path)
    assert {(one.kind, one.what, one.robot) for one in found} == {("alarm", "battery", R0)}
    assert (found[0].change, found[0].words, found[0].priority) == ("raised", "battery 15 %", "low")
    assert found[1].change == "acknowledged"
    assert found[-1].change == "returned, cleared"
    assert len(found) == 3


def test_an_alarm_of_a_link_names_its_address(tmp_path: Path) -> None:
    store, _ = watched(tmp_path)
    for fact in (link_lost(T0 + 1), tick(T0 + 1), tick(T0 + 10)):
        store.apply(fact)
    first = read(tmp_path)[0]
    assert (first.kind, first.what, first.change, first.robot) == ("alarm", "link", "raised", "")
    assert (first.link, first.url) == ("rosbridge", "ws://site:9090")
    assert first.words.startswith("no link")


@pytest.mark.parametrize(
    ("url", "kept"),
    [
        ("wss://ana:secret@site:9090/ros?token=secret#secret", "wss://***@site:9090/ros?***"),
        ("wss://secret@site:9090/ros", "wss://***@site:9090/ros"),
        ("wss://site:9090/ros#secret", "wss://site:9090/ros#***"),
    ],
)
def test_no_secret_of_an_address_is_kept(tmp_path: Path, url: str, kept: str) -> None:
    store = Store(initial_state(config_of(url), T0))
    store.watchers.append(Audit(audit_file(tmp_path / FILE_NAME), ANA).watch)
    give(store, 1, ORDER, Stage.SENT)
    assert {one.url for one in read(tmp_path)} == {kept}


def test_what_was_asked_of_many_robots_is_summed_up_once_it_is_decided() -> None:
    asked = [*commanded(1, PauseRobot(R0), Stage.SENT), *commanded(2, PauseRobot("robot_1"), Stage.SENT)]
    states = [fleet(2)]
    refusals = [CommandAdvanced(id_, Stage.REFUSED, T0 + 1, Message("busy")) for id_ in (1, 2)]
    for fact in (*asked, *refusals):
        states.append(reduced(states[-1], fact))
    found = [
        [one for one in command_records(ANA, *pair, lambda at: at) if one.change == "summary"]
        for pair in pairwise(states)
    ]
    assert [len(one) for one in found] == [0] * (len(found) - 1) + [1]
    (summary,) = found[-1]
    assert (summary.kind, summary.what) == ("command", "pause all")
    assert summary.words == "2 refused (robot_0, robot_1): busy"


def test_what_another_console_of_the_desk_answered_is_signed_by_its_operator() -> None:
    before = reduced(fleet(), link_up(T0), link_lost(T0 + 1), tick(T0 + 10))
    after = reduced(before, AlarmAcknowledged(by="ben"))
    (found,) = alarm_records(ANA, before, after, 1e9)
    assert (found.operator, found.change, found.what) == ("ben", "acknowledged elsewhere", "link")
    (own,) = alarm_records(ANA, before, reduced(before, AlarmAcknowledged()), 1e9)
    assert (own.operator, own.change) == (ANA.operator, "acknowledged")
