"""Names of simulated fleets and of the robots in them."""

FLEETS = ("tiny", "carrier")
"""The usual fleets, which take turns."""


def fleet_of(turn: int, fleets: tuple[str, ...] = FLEETS) -> str:
    """Return the fleet of the robot whose turn it is."""
    return fleets[turn % len(fleets)]


def full_name(turn: int, index: int, fleets: tuple[str, ...] = FLEETS) -> str:
    """Return the name of the robot with a number, behind that of its fleet."""
    return f"{fleet_of(turn, fleets)}/robot_{index}"
