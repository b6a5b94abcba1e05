"""The `config init` command: a configuration to start from, from the robots of a bridge."""

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path

from fleet_tui.config.load import shipped
from fleet_tui.config.saving import write_config
from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.address import bridge_at
from fleet_tui.links.discovery.site import DiscoveredSite, start_discovery
from fleet_tui.links.discovery.vehicles import STATE_EVERY
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


def example() -> str:
    """Return the configuration shipped with the program."""
    return shipped().read_text(encoding="utf-8")


def from_live(known: Config, url: str, timeout: float, wait: float) -> DiscoveredSite:
    """Return the site behind the bridge or broker at `url`, reached with the settings that `known` has for
    it, else with those of its [rosbridge].

    Raises ConfigError for an invalid address, LinkError if it can't be reached, FleetError if rosapi fails.
    """
    whole = known.whole()
    same = (link for link in whole.links.values() if link.url == url)
    bridge = bridge_at(url, next(same, whole.rosbridge))
    return start_discovery(bridge, timeout, wait=wait).result()


def write(text: str, output: str, force: bool, say: Callable[[str], None]) -> None:
    """Print it, or write it to a new file. Raises FleetError."""
    if not output:
        say(text.rstrip("\n"))
        return
    if force:
        write_config(text, output)
        return
    try:
        with Path(output).expanduser().open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise FleetError(Message("{output} exists: overwrite with --force", output=output)) from None
    except OSError as problem:
        raise FleetError(Message("{output}: {strerror}", output=output, strerror=problem.strerror)) from None


def _listening(seconds: float) -> str:
    """Return for how long vehicles were listened for, and whom that may have missed."""
    text = f"listened for {seconds:.0f} s, the last 2 without a further vehicle"
    if seconds > STATE_EVERY:
        return f"listened for {seconds:.0f} s: each vehicle that is on has sent a state"
    return (
        f"{text}. One whose connection the broker does not retain may be silent for {STATE_EVERY:.0f} s: "
        f"--wait {STATE_EVERY + 5:.0f} finds it"
    )


def next_steps(site: DiscoveredSite | None, output: str) -> Iterator[str]:
    """Return the findings, with every uncertain setting, and what to do next."""
    if site is None:
        edit = "set the address of your rosbridge and your robots, then type: "
    else:
        yield f"{site.bridge.shown}: {site.summary}"
        if site.bridge.is_broker:
            yield _listening(site.listened)
        yield from (f"warning: {line}" for line in site.warnings)
        edit = "correct what is uncertain, then type: " if site.warnings else ""
    if not output:
        yield f"Next: write it with --output config.toml, {edit}fleet-tui check && fleet-tui"
        return
    file = shlex.quote(output)
    check, config = ("", "") if output == "config.toml" else (f" {file}", f" --config {file}")
    yield f"wrote {output}. Next: {edit}fleet-tui check{check} && fleet-tui{config}"
