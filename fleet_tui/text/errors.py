"""Errors for operators: each message names the object and the remedy."""

from collections.abc import Iterable
from difflib import get_close_matches

from fleet_tui.text.language import EMPTY, Message, joined, verbatim


class FleetError(Exception):
    """Base of every error the program raises on purpose."""

    def __init__(self, text: Message) -> None:
        super().__init__(text)


class ConfigError(FleetError):
    """One or more problems in the configuration; `problems` holds one line each."""

    def __init__(self, problems: list[str]) -> None:
        super().__init__(joined("\n", problems))
        self.problems = problems


class NoConfigError(ConfigError):
    """No configuration was named, and none was found."""


class WireError(FleetError):
    """A message that does not match the profile; its text is for the log, in English."""

    def __init__(self, text: str) -> None:
        super().__init__(verbatim(text))


class LinkError(FleetError):
    """No connection to the robots."""


class CommandError(FleetError):
    """A command that must not be sent, and the reason."""


class MapError(FleetError):
    """A map that can't be drawn, and the reason."""


class RoutineError(FleetError):
    """A routine that can't be read, started or resumed, with the remedy."""


class GraphError(FleetError):
    """A graph file that can't be read, and the reason."""


def is_address(word: str) -> bool:
    """Tell whether a word can only be an address: it has a scheme, a host and a port, or four numbers."""
    host, colon, rest = word.rpartition(":")
    is_host = word == "localhost" or (word.count(".") == 3 and word.replace(".", "").isdecimal())
    return is_host or "://" in word or bool(host and colon and rest.partition("/")[0].isdecimal())


def did_you_mean(word: str, known: Iterable[str]) -> Message:
    """Return `, did you mean NAME?` if a known name is similar, in any case."""
    names = {name.casefold(): name for name in sorted(known)}
    # The search for similar names takes time with the square of the length.
    near = get_close_matches(word[:80].casefold(), names, n=1, cutoff=0.6)
    return Message(", did you mean {names}?", names=names[near[0]]) if near else EMPTY


STOPPED = Message("server not responding")
UNANSWERED = Message("reached, but no answer")
"""Why there is no connection if its port takes connections, and nothing is ever answered, or not any more."""
