"""The fleet state before any message."""

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
            alarms.offline_after,
            alarms.obstacle_after,
            alarms.battery_low,
            alarms.battery_critical,
            alarms.no_link_after,
            alarms.not_confirmed_after,
            alarms.stuck_after,
            alarms.pause_after,
            alarms.battery_band,
            alarms.clear_after,
            alarms.shelve_for,
            tuple(alarms.latched),
        ),
        now=now,
    )


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
