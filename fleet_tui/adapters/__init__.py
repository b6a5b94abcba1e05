"""Adapters: one folder for each kind of robot, chosen by the profile's name."""

from collections.abc import Callable

from fleet_tui.adapters.interface import Interface
from fleet_tui.adapters.oh_ressources import adapter as oh_ressources
from fleet_tui.config.profile import Profile

KINDS: dict[str, Callable[[Profile], Interface]] = {"oh_ressources": oh_ressources.interface}
