"""What can go wrong, in the words an operator reads. The message names the thing and the remedy."""


class FleetError(Exception):
    """Base of every error the program raises on purpose."""


class ConfigError(FleetError):
    """One or more problems in the configuration; `problems` holds one line each."""

    def __init__(self, problems: list[str]) -> None:
        super().__init__("\n".join(problems))
        self.problems = problems


class WireError(FleetError):
    """What came over the wire is not what the interface profile promises."""


class LinkError(FleetError):
    """There is no way through to the robots now."""


class CommandError(FleetError):
    """A command that must not be sent, and why."""


class MapError(FleetError):
    """A map that can't be drawn, and why."""
