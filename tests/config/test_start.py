"""The picture before anything has been heard."""

from fleet_tui.config.start import initial_state
from fleet_tui.model.link import Phase
from tests.support.watched_store import config_of


def test_every_floor_robot_and_link_is_there_and_nothing_is_known() -> None:
    state = initial_state(config_of("ws://ana:hush@site", 2, 3), 5.0)
    assert (list(state.robots), list(state.floors), state.now) == (
        ["robot_0", "robot_1"],
        ["floor_0", "floor_1", "floor_2"],
        5.0,
    )
    assert [robot.number for robot in state.robots.values()] == [1, 2]
    assert all(robot.pose is None and robot.last_received is None for robot in state.robots.values())
    (link,) = state.links.values()
    assert link.phase is Phase.CONNECTING and "hush" not in link.url


def test_limits_are_those_of_the_config() -> None:
    config = config_of("ws://a")
    assert initial_state(config, 0.0).limits.battery_low == config.alarms.battery_low
    assert initial_state(config, 0.0).robots["robot_0"].says_paused
