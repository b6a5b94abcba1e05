"""The settings of one console, fixed while it runs."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from msgspec import Struct

from fleet_tui.config.programs import ProgramEntry
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.problem import Permissions
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.view.map.drawing import Drawing


class ConsoleSettings(Struct, frozen=True):
    """`keys`: the keys of each id; `clock`: Unix seconds as text; `permissions`: those at the start;
    `themes`: for each a function that switches to it; `announce` is called with every state, `resized` after
    a change of size; `hatched`: colours don't tell unknown ground from floor; `terminal`: its description in
    help; `message`: the first notice; `programs`: of the configuration; `drive`: limits
    by robot; `picture_limit`: bytes a second to the terminal above which pictures of cameras come less often;
    `routines`: their folder; `doubt`: of the configuration."""

    keys: Mapping[str, tuple[str, ...]]
    clock: Callable[[float], str]
    permissions: Permissions
    drawing: Drawing
    themes: Mapping[str, Callable[[], None]]
    announce: Callable[[FleetState], None]
    resized: Callable[[], None]
    terminal: str = ""
    message: Message = EMPTY
    programs: Sequence[ProgramEntry] = ()
    drive: Mapping[str, DriveConfig] = {}
    routines: Path = Path()
    doubt: Message = EMPTY
    picture_limit: float = 60_000.0
