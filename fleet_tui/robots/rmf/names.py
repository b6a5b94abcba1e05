"""Names of robots: that of the fleet and that of the robot in it, joined by a slash."""


def robot_name(fleet: str, name: str) -> str:
    return f"{fleet}/{name}"


def fleet_and_name(robot: str) -> tuple[str, str]:
    fleet, _, name = robot.partition("/")
    return fleet, name
