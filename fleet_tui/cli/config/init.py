"""`fleet-tui config init`: a configuration to start from, made of what a bridge has."""

from collections.abc import Callable
from pathlib import Path

from fleet_tui.config.load import shipped
from fleet_tui.config.schema import Config
from fleet_tui.discovery.address import bridge_at
from fleet_tui.discovery.site import start_discovery
from fleet_tui.errors import FleetError


def example() -> str:
    """The configuration that comes with the program."""
    return shipped().read_text(encoding="utf-8")


def from_live(known: Config, url: str, timeout: float) -> str:
    """A configuration for what is behind the bridge at `url`, which is reached as `known` says.

    Raises ConfigError for an address that is none, LinkError where there is no way, FleetError
    where rosapi does not tell.
    """
    bridge = bridge_at(url, known.whole().rosbridge)
    return start_discovery(bridge, timeout).result().text


def write(text: str, output: str, force: bool, say: Callable[[str], None]) -> None:
    """Print it, or write it to a file that is not there yet. Raises FleetError."""
    if not output:
        say(text.rstrip("\n"))
        return
    try:
        with Path(output).expanduser().open("w" if force else "x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise FleetError(f"{output} exists: overwrite with --force") from None
    except OSError as problem:
        raise FleetError(f"{output}: {problem.strerror}") from None
