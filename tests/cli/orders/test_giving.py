"""Commands without a screen: who may give them, which robots a word means, and what is said of each."""

import json
from typing import Any

import click
import pytest
from msgspec.structs import replace

from fleet_tui.cli.orders.giving import forbidden, how, robots_of, said, unreachable
from fleet_tui.cli.orders.outcome import DONE, NO_LINK, NOT_DONE, Outcome
from fleet_tui.config.schema import Operator
from fleet_tui.model.problem import Permissions
from tests.support.desk import ready
from tests.support.fleets import R0, T0, fleet, link_lost, reduced
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 3)


class Said:
    """The output of a command, by stream."""

    def __init__(self) -> None:
        self.out, self.err = list[str](), list[str]()

    def __call__(self, text: str, err: bool = False) -> None:
        (self.err if err else self.out).append(text)


@pytest.mark.parametrize(
    ("operator", "words"),
    [
        (Operator(), ""),
        (Operator(read_only=True), "this console is read-only: operator.read_only in "),
        (Operator(armed=False), "this console is not armed: operator.armed in "),
    ],
)
def test_a_console_that_may_not_says_which_line_forbids_it(operator: Operator, words: str) -> None:
    config = replace(CONFIG, operator=operator)
    assert forbidden(config).startswith(words) and bool(forbidden(config)) is bool(words)
    assert how(config, 3.0, True).permissions == Permissions(operator.read_only, operator.armed)


def test_a_word_means_one_robot_or_all() -> None:
    assert robots_of(CONFIG, "All") == ["robot_0", "robot_1", "robot_2"]
    assert robots_of(CONFIG, "robot_1") == ["robot_1"]
    with pytest.raises(click.UsageError, match="'robot_O', did you mean"):
        robots_of(CONFIG, "robot_O")


def test_the_first_robot_out_of_reach_is_the_reason() -> None:
    assert unreachable(ready(), [R0]) == ""
    assert "connection refused" in unreachable(reduced(ready(), link_lost(T0)), [R0])
    assert unreachable(fleet(2), ["robot_1", R0])


def outcome(robot: str, code: int) -> Outcome:
    return Outcome(
        robot, f"pause {robot}", f"{robot} pause", "confirmed" if code == DONE else "refused", "", code
    )


@pytest.mark.parametrize(("codes", "code"), [([DONE, DONE], DONE), ([DONE, NOT_DONE], NOT_DONE)])
def test_outcomes_are_said_one_by_one_and_failures_on_stderr(codes: list[int], code: int) -> None:
    say = Said()
    assert said((outcome(f"robot_{n}", one) for n, one in enumerate(codes)), False, say) == code
    assert len(say.out) == codes.count(DONE) and len(say.err) == len(codes) - codes.count(DONE)


def test_json_says_every_outcome_on_stdout() -> None:
    say = Said()
    assert said([outcome(R0, NO_LINK)], True, say) == NO_LINK
    (line,) = say.out
    values: dict[str, Any] = json.loads(line)
    assert (values["robot"], values["done"], say.err) == (R0, False, [])
