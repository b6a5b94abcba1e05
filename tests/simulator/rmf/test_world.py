"""The simulated hospital as a whole."""

from fleet_tui.simulator.rmf.fleet import RmfFleet


def test_robots_of_each_fleet_are_on_all_floors() -> None:
    world = RmfFleet(6, 3, seed=1)
    assert {one.fleet for one in world.robots.values()} == {"tiny", "carrier"}
    assert {one.body.floor.name for one in world.robots.values()} == {"floor_0", "floor_1", "floor_2"}


def test_other_clients_give_tasks_unless_it_is_quiet() -> None:
    busy, quiet = RmfFleet(4, 1, seed=1), RmfFleet(4, 1, seed=1, quiet=True)
    for world in (busy, quiet):
        world.step(60.0)
    assert any(one.changed for one in busy.robots.values())
    assert not any(one.changed for one in quiet.robots.values())
