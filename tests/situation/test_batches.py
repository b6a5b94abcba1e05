"""Commands given together, and how one request to many robots stands."""

from fleet_tui.model.commands import CommandRecord, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.batches import TOGETHER, batches, pauses, summary
from tests.support.fleets import T0, commanded, fleet, reduced


def paused(*stages: Stage, detail: str = "") -> FleetState:
    """A pause of all, each robot at its own stage."""
    facts = [
        fact
        for n, stage in enumerate(stages)
        for fact in commanded(n, PauseRobot(f"robot_{n}"), Stage.SENT, stage, detail=detail)
    ]
    return reduced(fleet(len(stages)), *facts)


def ids(found: list[list[CommandRecord]]) -> list[list[int]]:
    return [[record.id for record in batch] for batch in found]


def test_what_is_given_at_once_to_different_robots_is_one_wish() -> None:
    state = reduced(
        fleet(2),
        *commanded(1, PauseRobot("robot_0")),
        *commanded(2, PauseRobot("robot_1")),
        *commanded(3, PauseRobot("robot_1")),
        *commanded(4, ResumeRobot("robot_0")),
        *commanded(5, ResumeRobot("robot_1"), at=T0 + 2 * TOGETHER),
    )
    assert ids(batches(state.commands)) == [[1, 2], [3], [4], [5]]
    assert ids(pauses(state.commands)) == [[1, 2]]


def test_a_summary_counts_what_went_well_and_names_what_did_not() -> None:
    state = paused(Stage.REFUSED, Stage.ACCEPTED, Stage.ACCEPTED, detail="no")
    assert summary(state, state.commands) == (
        "pause all",
        "1 refused (robot_0): no, 2 open (robot_1, robot_2)",
    )


def test_some_robots_are_counted() -> None:
    state = paused(Stage.ACCEPTED, Stage.ACCEPTED, Stage.ACCEPTED)
    assert summary(state, state.commands[:2])[0] == "pause 2 robots"
