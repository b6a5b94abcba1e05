"""Values of navigating robots in JSON: null for what has not come, no key for what is never told."""

from typing import Any

from msgspec.structs import replace

from fleet_tui.cli.status.report import navigation
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Blocked, Progress
from fleet_tui.model.robot import Reading
from fleet_tui.model.set_up.commands import StartCharging
from tests.support.fleets import (
    R0,
    T0,
    commanded,
    fleet,
    graph,
    labels,
    of_kinds,
    place_order,
    queue,
    reduced,
    tick,
)

KIND = Kind("nav", ("pose", "queue", "progress", "blocked", "odometry"), keeps_goals=True)


def values(state: FleetState, **robot: Any) -> dict[str, Any]:
    return navigation(state, replace(state.robots[R0], **robot))


def site(kind: Kind = KIND) -> FleetState:
    return reduced(of_kinds(fleet(), kind), graph(1, 2), labels({2: "Store"}), tick(T0))


def test_a_kind_without_such_values_has_no_keys_and_one_not_heard_has_null() -> None:
    assert values(site(Kind("other", ("pose",)))) == {}
    names = "progress", "blocked", "blocked_s", "localisation_silent_s", "position_variance_m2", "held"
    none = dict.fromkeys(names)
    assert values(site()) == {**none, "kept_here": [], "not_ours": []}


def test_what_holds_it_back_and_how_sure_it_is() -> None:
    for action, seconds in (("stop", 4.2), ("slowdown", None)):
        found = values(site(), blocked=Reading(Blocked(action, "front", T0 - 4.21), T0))
        assert (found["blocked"], found["blocked_s"]) == (action, seconds)
    assert values(site(), variance=Reading(0.12345, T0))["position_variance_m2"] == 0.123


def test_orders_that_wait_here_and_orders_of_others() -> None:
    state = reduced(
        site(), *commanded(1, place_order(R0, 1, 2), Stage.WAITING), queue(T0, (7, 1, 2, "W"), current=7)
    )
    found = values(state, held="previous order: failed")
    assert found["kept_here"] == [{"id": "k1", "mission": "1 -> Store"}]
    assert (found["held"], found["not_ours"]) == ("previous order: failed", ["7"])
    charge = reduced(site(), *commanded(1, StartCharging(R0), Stage.WAITING))
    assert values(charge)["kept_here"] == [{"id": "k1", "mission": "start charging"}]


def test_progress_is_that_of_an_order_and_fresh() -> None:
    driving = reduced(site(), queue(T0, (7, 1, 2, "W"), current=7))
    progress = Progress("7", 4.0, 9.0, 12.0, 1, 2)
    found = values(driving, progress=Reading(progress, T0), last_received=T0)["progress"]
    assert found == {"metres": 4.0, "seconds": 9.0, "elapsed_s": 12.0, "recoveries": 1, "stop": 2}
    assert values(driving, progress=Reading(progress, T0 - 60), last_received=T0)["progress"] is None
    assert values(site(), progress=Reading(progress, T0), last_received=T0)["progress"] is None
