"""Reports that set-up commands are checked against: a robot that stands, and the map of its floor."""

from collections.abc import Sequence

from fleet_tui.cli.orders.sending import Sending
from fleet_tui.commands.language.set_up import floor_of
from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.reported_motion import SELDOM, STANDS_AFTER, is_moving
from fleet_tui.text.errors import CommandError

STANDING_WITHIN = STANDS_AFTER + SELDOM + 1.0
"""Seconds until a robot at rest has been seen for long enough to count as standing."""
MAP_WITHIN = 3.0


def await_set_up(given: Sending, config: Config, name: str, words: Sequence[str]) -> None:
    """Wait for the reports that a set-up command needs besides those of an order."""
    if words[0] in ("set-pose", "localise"):

        def stands(state: FleetState) -> bool:
            return not is_moving(state.robots[name], state.now)

        given.store.wait(stands, min(STANDING_WITHIN, given.left))
    if words[0] in ("set-pose", "goto") and len(words) > 3:
        _await_map(given, config, name)


def _await_map(given: Sending, config: Config, name: str) -> None:
    """Load the map of a robot's floor, or subscribe to its live one."""
    robot = given.state.robots[name]
    try:
        floor = floor_of(robot)
    except CommandError:
        return
    entry = next(one for one in config.floors if one.name == floor)
    if entry.map:
        # With numpy, whose import takes longer than a whole command.
        from fleet_tui.maps.images import load_floor_map

        given.link.post(load_floor_map(floor, config.beside(entry.map), config.profile.origin == "added"))
    elif "map" in robot.kind.reports:
        given.link.show_map(name, floor)
    else:
        return

    def has_map(state: FleetState) -> bool:
        known = map_of(state, state.robots[name], floor) is not None
        return known or bool(state.floors[floor].problem)

    given.store.wait(has_map, min(MAP_WITHIN, given.left))
