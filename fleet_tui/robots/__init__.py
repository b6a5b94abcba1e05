"""The interpreters: one module for each kind of robot, chosen by the profile's name."""

from collections.abc import Callable

from fleet_tui.config.profile import Profile
from fleet_tui.robots import oh_ressources
from fleet_tui.robots.interface import Interface

KINDS: dict[str, Callable[[Profile], Interface]] = {"oh_ressources": oh_ressources.interface}
