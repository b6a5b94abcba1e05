"""The picture before anything has been heard."""

import msgspec
from msgspec.structs import replace

from fleet_tui.config.schema import Alarms
from fleet_tui.config.start import initial_state
from fleet_tui.model.fleet import Limits
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


def test_each_limit_is_that_of_its_key_in_the_config() -> None:
    values = {
        name: float(number) for number, name in enumerate(Alarms.__struct_fields__[:12], 1)
    }  # the rest are no numbers
    alarms = msgspec.convert({**values, "latched": ["robot"]}, Alarms)
    config = replace(config_of("ws://a"), alarms=alarms)
    assert initial_state(config, 0.0).limits == Limits(
        offline_after=values["offline_after"],
        obstacle_after=values["obstacle_after"],
        battery_low=values["battery_low"],
        battery_critical=values["battery_critical"],
        link_after=values["no_link_after"],
        confirm_after=values["not_confirmed_after"],
        stuck_after=values["stuck_after"],
        pause_after=values["pause_after"],
        battery_band=values["battery_band"],
        clear_after=values["clear_after"],
        shelve_for=values["shelve_for"],
        latched=("robot",),
    )


def test_a_robot_of_the_source_says_that_it_is_paused() -> None:
    assert initial_state(config_of("ws://a"), 0.0).robots["robot_0"].says_paused
