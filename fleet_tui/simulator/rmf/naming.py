"""Names of simulated fleets and of the robots in them."""

FLEETS = ("tiny", "carrier")
"""The usual fleets, which take turns."""


def fleet_of(index: int, fleets: tuple[str, ...] = FLEETS) -> str:
    """Return the fleet of the robot with this number."""
    return fleets[index % len(fleets)]


def full_name(index: int, fleets: tuple[str, ...] = FLEETS) -> str:
    """Return the name of a robot with that of its fleet."""
    return f"{fleet_of(index, fleets)}/robot_{index}"
