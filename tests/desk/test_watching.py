"""Claims for a command without a screen."""

from pathlib import Path

from fleet_tui.config.schema import Config, DeskConfig
from fleet_tui.desk.watching import watched_claims
from fleet_tui.model.desk.events import ColleaguesSeen, RobotClaimed
from fleet_tui.model.events import Event
from tests.support.shared_desk import R3, at_desk


def config(folder: str, path: Path) -> Config:
    return Config(desk=DeskConfig(folder), path=path / "config.toml")


def test_claims_are_known_before_the_first_command(tmp_path: Path) -> None:
    (tmp_path / "desk").mkdir()
    with at_desk(tmp_path / "desk", "ana", "ben") as (ana, ben):
        ana.post(RobotClaimed(R3))
        ben.becomes(lambda state: state.desk.holders(R3))
        found, said = list[Event](), list[str]()
        with watched_claims(config("desk", tmp_path), found.append, said.append):
            first = found[0]
        assert isinstance(first, ColleaguesSeen)
        assert [(one.name, one.claims) for one in first.others] == [("ana", (R3,)), ("ben", ())]
        assert said == []


def test_a_desk_that_is_not_there_is_told_and_holds_nothing_back(tmp_path: Path) -> None:
    found, said = list[Event](), list[str]()
    with watched_claims(config("gone", tmp_path), found.append, said.append):
        pass
    assert found == [] and said == [f"desk: claims unknown: {tmp_path / 'gone'}: No such file or directory"]
    with watched_claims(config("", tmp_path), found.append, said.append):
        pass
    assert len(said) == 1
