"""The fleet state before any message."""

from msgspec.structs import replace

from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState, Floor, Limits
from fleet_tui.model.geometry import Pose
from fleet_tui.model.link import LinkState
from fleet_tui.model.robot import Robot, RobotMap


def initial_state(config: Config, now: float) -> FleetState:
    """Return every floor, robot and link of the config, without values. `now` is monotonic."""
    alarms = config.alarms
    return FleetState(
        floors={floor.name: Floor(floor.name, floor.frame) for floor in config.floors},
        robots=_robots(config),
        links={
            name: LinkState(name, link.shown, since=now, site=link.site)
            for name, link in config.bridges.items()
        },
        limits=Limits(
            offline_after=alarms.offline_after,
            obstacle_after=alarms.obstacle_after,
            battery_low=alarms.battery_low,
            battery_critical=alarms.battery_critical,
            link_after=alarms.no_link_after,
            confirm_after=alarms.not_confirmed_after,
            stuck_after=alarms.stuck_after,
            pause_after=alarms.pause_after,
            battery_band=alarms.battery_band,
            clear_after=alarms.clear_after,
            shelve_for=alarms.shelve_for,
            latched=tuple(alarms.latched),
        ),
        now=now,
    )


def extended(state: FleetState, config: Config) -> FleetState:
    """Return the state with the floors and robots that a configuration has besides, and its frames."""
    new = initial_state(config, state.now)
    floors = {
        name: replace(state.floors.get(name, floor), frame_id=floor.frame_id)
        for name, floor in new.floors.items()
    }
    known = {
        name: replace(robot, maps={**new.robots[name].maps, **robot.maps})
        for name, robot in state.robots.items()
    }
    return replace(state, floors=floors, robots={**new.robots, **known})


def _robots(config: Config) -> dict[str, Robot]:
    adapters = adapters_of(config)
    return {
        robot.name: Robot(
            robot.name,
            number,
            robot.link,
            {floor: RobotMap() for floor in config.floors_of(robot)},
            says_paused="paused" in adapters[robot.name].kind.reports,
            kind=adapters[robot.name].kind,
            size=robot.size,
            laser=Pose(*robot.laser) if robot.laser else None,
            laser_flipped=robot.laser_flipped,
            base_frame=adapters[robot.name].names.base_frame(robot.name),
        )
        for number, robot in enumerate(config.robots, 1)
    }
