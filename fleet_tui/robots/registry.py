"""The registry of kinds: one word for each, the name of its folder here."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    # A kind's modules are imported on use: a fleet of one kind does not wait for the others.
    from msgspec import Struct

    from fleet_tui.robots.adapter import Adapter, Site
    from fleet_tui.robots.discovery import Discovery, Listed
    from fleet_tui.robots.profile import Profile
    from fleet_tui.robots.ros.names import Vocabulary

DEFAULT_KIND = "oh_ressources"


@dataclass(frozen=True)
class Registered:
    """A kind of robots, whose folder has the modules `vocabulary`, `adapter`, `discovery` and, if it has
    settings of its own, `settings`."""

    folder: str

    def _module(self, name: str) -> Any:
        return import_module(f"{__package__}.{self.folder}.{name}")

    @property
    def vocabulary(self) -> "Vocabulary":
        """Return its usual names."""
        return cast("Vocabulary", self._module("vocabulary").VOCABULARY)

    @property
    def adapter(self) -> "Callable[[Profile, Site], Adapter]":
        return cast("Callable[[Profile, Site], Adapter]", self._module("adapter").ADAPTER)

    @property
    def discover(self) -> "Callable[[Listed], Discovery]":
        """Recognise such robots among the names that a bridge lists."""
        return cast("Callable[[Listed], Discovery]", self._module("discovery").discover)

    @property
    def samples(self) -> "tuple[str, ...]":
        """Return the keys of the topics whose messages name such robots, empty if names of topics do."""
        return cast("tuple[str, ...]", getattr(self._module("discovery"), "SAMPLES", ()))

    @property
    def settings(self) -> "type[Struct] | None":
        """Return the table of a profile that only this kind has."""
        if find_spec(f"{__package__}.{self.folder}.settings") is None:
            return None
        return cast("type[Struct]", self._module("settings").SETTINGS)


KINDS = {name: Registered(name) for name in ("oh_ressources", "nav2", "move_base", "rmf", "vda5050")}


def kind_of(profile: "Profile") -> str:
    return profile.kind or profile.name or DEFAULT_KIND
