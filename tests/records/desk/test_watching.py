"""The desk for a command without a screen."""

import re
from pathlib import Path

from fleet_tui.config.schema import Config, DeskConfig
from fleet_tui.model.commands import CancelOrder, ClearOrders, Stage
from fleet_tui.model.desk.events import ColleaguesSeen, CommandedElsewhere, RobotClaimed
from fleet_tui.model.events import Event
from fleet_tui.records.desk.watching import watched_desk
from fleet_tui.state.store import Store
from tests.support.fleets import R0, commanded, fleet
from tests.support.polling import eventually
from tests.support.records import give
from tests.support.shared_desk import R3, at_desk


def config(folder: str, path: Path) -> Config:
    return Config(desk=DeskConfig(folder), path=path / "config.toml")


def test_claims_are_known_before_the_first_command(tmp_path: Path) -> None:
    (tmp_path / "desk").mkdir()
    with at_desk(tmp_path / "desk", "ana", "ben") as (ana, ben):
        ana.post(RobotClaimed(R3))
        ben.becomes(lambda state: state.desk.holders(R3))
        found, said = list[Event](), list[str]()
        with watched_desk(config("desk", tmp_path), Store(fleet()), "cleo", found.append, said.append):
            first = found[0]
        assert isinstance(first, ColleaguesSeen)
        assert [(one.name, one.claims) for one in first.others] == [("ana", (R3,)), ("ben", ())]
        assert said == []


def test_a_desk_that_is_not_there_is_told_and_holds_nothing_back(tmp_path: Path) -> None:
    found, said = list[Event](), list[str]()
    with watched_desk(config("gone", tmp_path), Store(fleet()), "cleo", found.append, said.append):
        pass
    assert found == [] and said == [f"desk: claims unknown: {tmp_path / 'gone'}: No such file or directory"]
    with watched_desk(config("", tmp_path), Store(fleet()), "cleo", found.append, said.append):
        pass
    assert len(said) == 1


def test_what_a_command_line_removes_is_known_at_the_consoles_and_the_other_way_round(tmp_path: Path) -> None:
    (tmp_path / "desk").mkdir()
    with at_desk(tmp_path / "desk", "ana") as (ana,):
        found, said, store = list[Event](), list[str](), Store(fleet())
        with watched_desk(config("desk", tmp_path), store, "cleo", found.append, said.append):
            give(store, 1, CancelOrder(R0, "7"), Stage.SENT)
            ana.becomes(lambda state: state.desk.elsewhere)
            for fact in commanded(2, ClearOrders(R3), Stage.SENT):
                ana.post(fact)
            eventually(lambda: any(isinstance(one, CommandedElsewhere) for one in found))
            give(store, 3, ClearOrders(R0), Stage.SENT)
        ana.becomes(lambda state: len(state.desk.elsewhere) == 2)  # also what was done just before its end
        (cancelled, cleared) = ana.state.desk.elsewhere
    assert (cancelled.robot, cancelled.order_id, cleared.order_id) == (R0, "7", "")
    assert re.fullmatch(r"cancelled by cleo at \S+:\d+", cancelled.text)
    (told,) = (one.command for one in found if isinstance(one, CommandedElsewhere))
    assert (told.robot, told.stage) == (R3, Stage.SENT) and told.text.startswith("cleared by ana at ")
