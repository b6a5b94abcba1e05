"""The `:site NAME` command: show another site of the console."""

from collections.abc import Callable
from functools import partial

from fleet_tui.controllers.typed import Typed
from fleet_tui.errors import did_you_mean
from fleet_tui.model.fleet import FleetState
from fleet_tui.rules.sites import robots_at, sites_of
from fleet_tui.text.sanitize import sanitize

WORD = "site"


def typed_site(line: str, state: FleetState, find: Callable[[str], None]) -> Typed | None:
    """Parse a typed line as a site to show, None if it is not one. `find` selects its first robot."""
    word, _, name = line.strip().partition(" ")
    if word.casefold() != WORD:
        return None
    sites = [site for site in sites_of(state) if site]
    name = name.strip()
    if not sites:
        return Typed(problem="this console has one site: give links a site in the configuration")
    if name not in sites:
        near = [f"{WORD} {site}" for site in sites if site.startswith(name)]
        problem = f"no site {sanitize(name)}{did_you_mean(name, sites)}" if name and not near else ""
        return Typed(completed=near, problem=problem or f"site NAME: {sanitize(', '.join(sites))}")
    robots = robots_at(state, name)
    if not robots:
        return Typed(problem=f"site {sanitize(name)} has no robots")
    return Typed([(f"Go to site {sanitize(name)}", partial(find, robots[0]))])
