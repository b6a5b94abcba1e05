"""The store: who watches hears of commands and alarms, before anything else happens."""

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.store import Store
from tests.support.fleets import R0, T0, battery, commanded, fleet, link_up, reduced, tick


def test_a_watcher_hears_of_commands_and_alarms_and_of_nothing_else() -> None:
    store, seen = Store(fleet()), list[tuple[FleetState, FleetState]]()
    store.watchers.append(lambda before, after: seen.append((before, after)))
    for fact in (link_up(T0), battery(T0, 80.0), tick(T0 + 1)):
        store.apply(fact)
    assert seen == []
    (issued,) = commanded(1, PauseRobot(R0))
    before = store.state
    store.apply(issued)
    assert seen == [(before, store.state)] and store.state.commands
    store.apply(battery(T0 + 1, 5.0))
    store.apply(tick(T0 + 1))
    assert seen[-1][1].alarms and not seen[-1][0].alarms


def test_what_is_applied_together_is_told_once_after_the_last() -> None:
    store, seen = Store(fleet(2)), list[tuple[FleetState, FleetState]]()
    store.watchers.append(lambda before, after: seen.append((before, after)))
    before = store.state
    with store.together():
        for n in range(2):
            store.apply(*commanded(n, PauseRobot(f"robot_{n}")))
        assert not seen
    assert seen == [(before, store.state)] and len(store.state.commands) == 2
    store.apply(*commanded(2, PauseRobot(R0)))
    assert len(seen) == 2, "later events are told one by one"


def test_another_moment_is_put_in_its_place_unwatched() -> None:
    store, seen = Store(fleet()), list[FleetState]()
    store.watchers.append(lambda _before, after: seen.append(after))
    other = reduced(fleet(), *commanded(1, PauseRobot(R0), Stage.SENT))
    store.put(other)
    assert store.state is other and not seen
