"""The registry of kinds: one line for each."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from msgspec import Struct

from fleet_tui.adapters.adapter import Adapter, Site
from fleet_tui.adapters.discovery import Discovery, Listed
from fleet_tui.adapters.nav2.adapter import Nav2
from fleet_tui.adapters.nav2.discovery import discover as discover_nav2
from fleet_tui.adapters.nav2.settings import Settings as Nav2Settings
from fleet_tui.adapters.nav2.vocabulary import VOCABULARY as NAV2
from fleet_tui.adapters.oh_ressources.adapter import OhRessources
from fleet_tui.adapters.oh_ressources.discovery import discover as discover_oh_ressources
from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY as OH_RESSOURCES
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.names import Vocabulary

DEFAULT_KIND = "oh_ressources"


@dataclass(frozen=True, slots=True)
class Registered:
    """A kind of robots: its usual names, what makes its adapter, what recognises such robots behind a bridge,
    and what its own table of a profile holds."""

    vocabulary: Vocabulary
    adapter: Callable[[Profile, Site], Adapter]
    discover: Callable[[Listed], Discovery]
    settings: type[Struct] | None = None


KINDS: Mapping[str, Registered] = {
    "oh_ressources": Registered(OH_RESSOURCES, OhRessources, discover_oh_ressources),
    "nav2": Registered(NAV2, Nav2, discover_nav2, Nav2Settings),
}


def kind_of(profile: Profile) -> str:
    """Return the kind of robots that a profile is for."""
    return profile.kind or profile.name or DEFAULT_KIND
