"""What a question was asked about: it is void once that is gone or another."""

from collections.abc import Sequence

import pytest

from fleet_tui.commands.subject import subject_of, what_changed
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot
from fleet_tui.model.events import Event, PausedReported
from fleet_tui.model.request import Request
from tests.support.fleets import (
    R0,
    T0,
    fleet,
    graph,
    labels,
    link_up,
    place_order,
    pose,
    queue,
    reduced,
    tick,
)

FIRST = (1, 1, 2, "S")
OTHER = (1, 2, 1, "S")
PAUSED, ON = PausedReported(R0, T0, True), PausedReported(R0, T0 + 1, False)
CANCEL, CLEAR, PAUSE, RESUME = CancelOrder(R0, "1"), ClearOrders(R0), PauseRobot(R0), ResumeRobot(R0)
GO = place_order(R0, 1, 2)
RENAMED = labels({1: "Packing", 2: "Base"})


def _known(*facts: Event) -> Sequence[Event]:
    return (link_up(T0), graph(1, 2), labels({1: "Base", 2: "Packing"}), pose(T0), *facts)


@pytest.mark.parametrize(
    ("command", "before", "after", "says"),
    [
        (CANCEL, [queue(T0, FIRST)], [], ""),
        (CANCEL, [queue(T0, FIRST)], [queue(T0 + 1, OTHER)], f"order 1 of {R0} is a different one now"),
        (
            CANCEL,
            [queue(T0, FIRST)],
            [queue(T0 + 1), queue(T0 + 2, FIRST)],
            f"order 1 of {R0} is a different one now",
        ),
        (CLEAR, [queue(T0, FIRST)], [queue(T0 + 1)], ""),
        (CLEAR, [queue(T0, FIRST)], [queue(T0 + 1, FIRST, (2, 2, 1, "S"))], f"{R0} has another order, 2"),
        (GO, [], [RENAMED], f"vertex 1 of {R0} is a different place now"),
        (PAUSE, [], [PAUSED], ""),
        (RESUME, [PAUSED], [PAUSED], ""),
        (RESUME, [PAUSED], [ON], f"{R0} is no longer paused"),
        (RESUME, [ON], [ON], ""),
    ],
)
def test_a_question_is_void_once_its_object_is_gone_or_another(
    command: Command, before: Sequence[Event], after: Sequence[Event], says: str
) -> None:
    request = Request((command,))
    asked = reduced(fleet(), *_known(*before), tick(T0))
    now = reduced(asked, *after, tick(T0 + 2))
    assert what_changed(now, request, subject_of(asked, request)) == says
