"""The structure of config.toml. Every key has a default, so that a short file suffices."""

import re
from pathlib import Path
from typing import Annotated, Literal, TypeVar
from urllib.parse import urlsplit

import msgspec

from fleet_tui.config.entries import DEFAULT_LINK, FloorEntry, Positive, RobotEntry
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.attention import Rates
from fleet_tui.robots.profile import DriveConfig, Profile
from fleet_tui.text.language import EMPTY, Message

S = TypeVar("S", bound=msgspec.Struct)

SECRETS = ("authorization", "rosauth", "user", "password")
"""Secrets of links: each is in a file or an environment variable, `KEY_file` or `KEY_env`."""
NOT_IN_FILE = ("path", "doubt", "withheld", "watches")
"""Fields of a configuration that no file sets."""
LINK_FILES = ("ca_file", "client_cert", "client_key", *(f"{key}_file" for key in SECRETS))

NotNegative = Annotated[float, msgspec.Meta(ge=0, lt=1e6)]
Percent = Annotated[float, msgspec.Meta(ge=0, le=100)]


def expanded(name: str) -> Path:
    """Return a path with ~ expanded; the ~ of an unknown user stays."""
    try:
        return Path(name).expanduser()
    except RuntimeError:
        return Path(name)


def link_key(name: str) -> str:
    """Return the config table of a link."""
    return name if name == DEFAULT_LINK else f"links.{name}"


class Link(msgspec.Struct, frozen=True):
    """`[rosbridge]` and `[links.NAME]`: the address of a bridge or broker, and the credentials for it.
    `profile` is that of its robots, `site` the one that it belongs to, `role` that of this console towards
    the vehicles of a broker.

    Files are relative to the config file. Secrets are in a file or in an environment variable, never here.
    """

    url: str = "ws://127.0.0.1:9090"
    max_message_mb: Annotated[float, msgspec.Meta(gt=0, le=2000)] = 128.0
    ca_file: str = ""
    client_cert: str = ""
    client_key: str = ""
    authorization_file: str = ""
    authorization_env: str = ""
    rosauth_file: str = ""
    rosauth_env: str = ""
    user_file: str = ""
    user_env: str = ""
    password_file: str = ""
    password_env: str = ""
    role: Literal["watch", "pause", "master"] = "watch"
    profile: str = ""
    site: str = ""

    @property
    def shown(self) -> str:
        """Return the url without possible secrets."""
        without_user = re.sub(r"^(\w+://)?.*@", r"\1***@", self.url, flags=re.DOTALL)
        return re.sub(r"([?#]).*", r"\1***", without_user, flags=re.DOTALL)

    @property
    def scheme(self) -> str:
        """Return the scheme of the address, which chooses the transport."""
        return self.url.partition(":")[0].lower()

    @property
    def host_and_port(self) -> tuple[str, int | None]:
        """Return the host of the address, and its port, None if it has none."""
        parts = urlsplit(self.url)
        return parts.hostname or "", parts.port

    @property
    def is_broker(self) -> bool:
        """Tell whether it leads to an MQTT broker."""
        return self.scheme in ("mqtt", "mqtts")

    @property
    def is_secure(self) -> bool:
        """Tell whether the server uses TLS."""
        return self.scheme in ("wss", "mqtts")


class Operator(msgspec.Struct, frozen=True):
    """`[operator]`: name and permission of the operator."""

    name: str = ""
    read_only: bool = False
    armed: bool = True


class Ui(msgspec.Struct, frozen=True):
    """`[ui]`: ticks per second of the screen, milliseconds between messages of a topic; a `language` has a
    catalogue of its name in `locales/`."""

    theme: str = "dark"
    drawing: Literal["auto", "braille", "half-block", "ascii"] = "auto"
    language: Literal["en", "pt", "de"] = "en"
    ticks_per_second: Annotated[float, msgspec.Meta(ge=1, le=30)] = 10.0
    pose_ms: Annotated[int, msgspec.Meta(ge=0, le=60_000)] = 100
    status_ms: Annotated[int, msgspec.Meta(ge=0, le=60_000)] = 500


class Alarms(msgspec.Struct, frozen=True):
    """`[alarms]`: limits, delays (seconds) and dead bands (per cent); `bell` and `notify` list the
    priorities (high, medium, low) that ring the terminal's bell or send it a notification; `latched` lists
    the classes of alarms that stay until they are acknowledged."""

    offline_after: Positive = 5.0
    obstacle_after: Positive = 30.0
    battery_low: Percent = 20.0
    battery_critical: Percent = 10.0
    no_link_after: Positive = 2.0
    no_answer_after: Positive = 5.0
    not_confirmed_after: Positive = 5.0
    stuck_after: Positive = 60.0
    pause_after: Positive = 300.0
    battery_band: NotNegative = 2.0
    clear_after: NotNegative = 3.0
    shelve_for: Positive = 1800.0
    latched: list[str] = msgspec.field(default_factory=lambda: ["command"])
    bell: list[str] = []
    notify: list[str] = []


class Notify(msgspec.Struct, frozen=True):
    """`[notify]`: a program and its arguments, started for new alarms of these priorities and classes."""

    command: list[str] = []
    classes: list[str] = msgspec.field(default_factory=lambda: ["high"])


class RecordingConfig(msgspec.Struct, frozen=True):
    """`[recording]`: the console always keeps the last `recent_minutes` (0: none) in `recent_mb` at most. A
    recording continues in a new file after `rotate_mb` or `rotate_minutes`; `keep` files stay, 0: all."""

    recent_minutes: Annotated[float, msgspec.Meta(ge=0, le=1440)] = 10.0
    recent_mb: Annotated[float, msgspec.Meta(ge=1, le=100_000)] = 64.0
    rotate_mb: Annotated[float, msgspec.Meta(ge=1, le=100_000)] = 256.0
    rotate_minutes: Annotated[float, msgspec.Meta(ge=1, le=100_000)] = 60.0
    keep: Annotated[int, msgspec.Meta(ge=0, le=100_000)] = 0


class HistoryConfig(msgspec.Struct, frozen=True):
    """`[history]`: the days for which it is kept, 0: none, and the size of its file above which the oldest
    days go."""

    days: Annotated[float, msgspec.Meta(ge=0, le=3660)] = 90.0
    megabytes: Annotated[float, msgspec.Meta(ge=1, le=100_000)] = 1000.0


class CameraConfig(msgspec.Struct, frozen=True):
    """`[camera]`: kilobytes a second to the terminal above which pictures of a camera come less often."""

    kB_per_s: Annotated[float, msgspec.Meta(gt=0, le=100_000)] = 60.0  # noqa: N815  # the unit's own letters


class DeskConfig(msgspec.Struct, frozen=True):
    """`[desk]`: the folder that the consoles of one fleet share, relative to the config file; empty: none."""

    folder: str = ""


class RoutinesConfig(msgspec.Struct, frozen=True):
    """`[routines]`: the folder of routine files, relative to the config file."""

    folder: str = "routines"


class Config(msgspec.Struct, frozen=True):
    """A whole configuration; `path` is its file, `doubt` how somebody else could have written that, and
    `withheld` tells what does not count for that reason, or for such files that it names. `watches`: this
    process gives no commands, whatever its operator may."""

    rosbridge: Link = Link()
    links: dict[str, Link] = {}
    floors: list[FloorEntry] = []
    robots: list[RobotEntry] = []
    operator: Operator = Operator()
    keys: dict[str, str] = {}
    ui: Ui = Ui()
    rates: Rates = Rates()
    alarms: Alarms = Alarms()
    notify: Notify = Notify()
    recording: RecordingConfig = RecordingConfig()
    history: HistoryConfig = HistoryConfig()
    camera: CameraConfig = CameraConfig()
    programs: list[ProgramEntry] = []
    routines: RoutinesConfig = RoutinesConfig()
    desk: DeskConfig = DeskConfig()
    drive: DriveConfig = DriveConfig()
    profile: Profile = Profile()
    profiles: dict[str, Profile] = {}
    path: Path = Path()
    doubt: Message = EMPTY
    withheld: list[str] = []
    watches: bool = False

    def link(self, name: str) -> Link:
        """Return a link, with or without robots."""
        return self.rosbridge if name == DEFAULT_LINK else self.links[name]

    @property
    def bridges(self) -> dict[str, Link]:
        """Return every bridge with robots, by name; without robots the default one."""
        known = {DEFAULT_LINK: self.rosbridge, **self.links}
        used = [robot.link for robot in self.robots] or [DEFAULT_LINK]
        return {name: known[name] for name in dict.fromkeys(used)}

    @property
    def routine_folder(self) -> Path:
        return self.beside(self.routines.folder).absolute()

    def bridge(self, name: str) -> Link:
        """Return one bridge, its files with absolute paths."""
        return self._whole(self.bridges[name], LINK_FILES)

    def whole(self) -> "Config":
        """Return the configuration for a file in another folder: all files with absolute paths."""
        return msgspec.structs.replace(
            self,
            rosbridge=self._whole(self.rosbridge, LINK_FILES),
            links={name: self._whole(link, LINK_FILES) for name, link in self.links.items()},
            floors=[self._whole(floor, ("map", "graph")) for floor in self.floors],
            routines=self._whole(self.routines, ("folder",)),
            desk=self._whole(self.desk, ("folder",)),
        )

    def _whole(self, part: S, keys: tuple[str, ...]) -> S:
        found = {key: getattr(part, key) for key in keys}
        return msgspec.structs.replace(
            part, **{key: str(self.beside(name)) for key, name in found.items() if name}
        )

    def beside(self, name: str) -> Path:
        """Return the path of a file named in the config: relative to the config file; ~ is the home."""
        return self.path.parent / expanded(name)

    def floors_of(self, robot: RobotEntry) -> list[str]:
        """Return the possible floors of a robot."""
        return robot.floors or [floor.name for floor in self.floors]
