"""Lifts, doors, dispensers and ingestors of a site, and the lanes of its fleets: read-only."""

from msgspec import Struct

from fleet_tui.text.language import EMPTY, N_, Message

LIFT = N_("lift")
DOOR = N_("door")
DISPENSER = N_("dispenser")
INGESTOR = N_("ingestor")
LANES = N_("lanes")


class Facility(Struct, frozen=True):
    """A facility as last reported at the monotonic second `at`. `sort` is one of the words above, `link` that
    of its site; `state` describes it in words, `fault` is the reason that robots can't use it, empty for
    none; `user` is the robot that has it, `closed` are the numbers of the closed lanes of fleet `name`."""

    sort: str
    name: str
    at: float
    state: Message = EMPTY
    fault: str = ""
    user: str = ""
    closed: tuple[str, ...] = ()
    link: str = ""

    @property
    def key(self) -> str:
        """Return its key among all facilities: names are unique for a link and a sort only."""
        return f"{self.link} {self.sort} {self.name}"
