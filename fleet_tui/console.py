"""Opens the console: what the terminal can do, themes, log, then the app."""

import codecs
import logging
import os
import shutil
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from fleet_tui.app import FleetApp
from fleet_tui.backend import Backend, connect_live
from fleet_tui.config.access import access_problems, unsafe_places
from fleet_tui.config.fleet import watching
from fleet_tui.config.load import user_folder
from fleet_tui.config.saving import Saving
from fleet_tui.config.schema import Config, Ui
from fleet_tui.config.start import initial_state
from fleet_tui.errors import ConfigError, FleetError, did_you_mean
from fleet_tui.log_file import log_to_file, state_folder
from fleet_tui.state.store import Store
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.themes import FleetTheme, load_themes
from fleet_tui.view.map.drawing import Drawing

if TYPE_CHECKING:
    from fleet_tui.discovery.site import DiscoveredSite
    from fleet_tui.recording.play.player import Player
    from fleet_tui.recording.recordings import Recordings

LOG = logging.getLogger(__name__)

COLOURLESS = ("dumb", "unknown", "vt100", "vt102", "vt220")
"""Terminals (TERM) without colour, of which Textual would ask the full 24 bits."""
IN_BROWSER = "TEXTUAL_DRIVER"
"""Set by `fleet-tui serve`: pipes to a browser stand for the terminal."""

MULTIPLEXERS = {"tmux": "TMUX", "screen": "STY"}


def _has_unicode() -> bool:
    """Whether the terminal shows more than ASCII: the Linux console's font does not, nor a plain locale."""
    try:
        unicode = codecs.lookup(sys.stdout.encoding or "ascii").name == "utf-8"
    except LookupError:
        unicode = False
    return unicode and os.environ.get("TERM") != "linux"


def _drawing(wanted: str) -> Drawing:
    """What is wanted, else braille where the terminal can."""
    if wanted != "auto":
        return Drawing(wanted)
    return Drawing.BRAILLE if _has_unicode() else Drawing.ASCII


def _colour() -> bool:
    """Whether colour is wanted and possible. Empty, NO_COLOR means nothing; Textual asks if it is there."""
    if os.environ.get("TERM") in COLOURLESS:
        os.environ["NO_COLOR"] = "1"
    elif not os.environ.get("NO_COLOR"):
        os.environ.pop("NO_COLOR", None)
    return "NO_COLOR" not in os.environ


def _terminal(drawing: Drawing, colour: bool) -> str:
    """What was found out about the terminal, and what follows from it."""
    term, colorterm = os.environ.get("TERM", "not set"), os.environ.get("COLORTERM", "not set")
    size = shutil.get_terminal_size()
    inside = next((name for name, mark in MULTIPLEXERS.items() if os.environ.get(mark)), "none")
    return (
        f"Terminal: {size.columns} x {size.lines}, TERM {term}, COLORTERM {colorterm},"
        f" multiplexer {inside}, encoding {sys.stdout.encoding}.\n"
        f"So the map starts as {drawing.value} (m or --drawing change it), colours are"
        f" {'on' if colour else 'off: NO_COLOR, or a terminal without'}."
    )


def need_terminal() -> None:
    """Raise FleetError where there is none."""
    streams = (sys.stdin, sys.stdout, sys.stderr)
    if IN_BROWSER not in os.environ and not all(stream.isatty() for stream in streams):
        raise FleetError("the console needs a terminal for input, output and errors: over SSH use ssh -t")


def _refuse(config: Config, themes: Mapping[str, FleetTheme]) -> None:
    """Raise ConfigError for what would only show once the screen is open."""
    refused = access_problems(config)
    if config.ui.theme not in themes:
        near = did_you_mean(config.ui.theme, themes)
        refused.append(f"ui.theme: no theme {config.ui.theme!r}{near}")
    if refused:
        raise ConfigError([f"{config.path}: {line}" for line in refused])


def open_console(
    config: Config,
    read_only: bool,
    drawing: str | None,
    debug: bool,
    demo: bool = False,
    site: "DiscoveredSite | None" = None,
) -> None:
    """Run the console until the operator leaves. What a `demo` did is marked in the audit log; `site`: where
    the configuration comes from that is in no file."""
    saving = None if demo else Saving(config, site)
    if read_only:
        config = watching(config)
    store = Store(initial_state(config, time.monotonic()))
    app = _ready(config, drawing, debug, partial(FleetApp, config, store))
    app.main.saving = saving
    if site is not None:
        arrived = f"{site.bridge.shown}: {site.summary}. :save keeps it"
        app.main.said = f"{arrived}; {app.main.said}" if app.main.said else arrived
    _run(app, config, demo)


def ask_first(site: "DiscoveredSite | None", drawing: str | None) -> "DiscoveredSite | None":
    """Run the screens before the console: what is not certain of a site, or where to go. Return what was
    chosen, None where the operator left."""
    from fleet_tui.config.load import looked_for
    from fleet_tui.entry import EntryApp

    theme = load_themes(user_folder() / "themes")[0][Ui().theme]
    app = EntryApp(theme, _colour(), site, looked_for())
    if _drawing(drawing or Ui().drawing) is Drawing.ASCII and not _has_unicode():
        from fleet_tui.terminal.plain_driver import PlainDriver

        app.driver_class = PlainDriver
    _to_the_end(app)
    return app.chosen


def recorded(
    recordings: "Recordings",
    folder: Path | None,
    config: Config,
    store: Store,
    stands: Callable[[Backend], None],
) -> None:
    """Connect to the fleet; what goes through it is recorded. `folder` is where orders are kept."""

    def keep(backend: Backend) -> None:
        stands(backend)
        recordings.keep_recent()

    from fleet_tui.audit.log import operator_name

    connect_live(config, store, keep, recordings.taps, folder, operator_name(config))


def open_replay(config: Config, player: "Player", drawing: str | None, debug: bool) -> None:
    """Run the console on a recording. No link is made, no audit log kept, no bell rung."""
    _to_the_end(_ready(config, drawing, debug, partial(replaying, config, player)))


def replaying(
    config: Config, player: "Player", themes: dict[str, FleetTheme], mode: Drawing, colour: bool = True
) -> FleetApp:
    """The app on a recording."""
    from fleet_tui.recording.play.backend import ReplayBackend

    app = FleetApp(config, Store(player.state), themes, mode, colour, ReplayBackend(player).open)
    app.main.player, app.main.read_only = player, True
    app.main.announce = lambda _state: None
    app.main.tell = lambda _event: app.main.say("nothing is acknowledged or shelved: this is a recording")
    return app


def _ready(
    config: Config,
    drawing: str | None,
    debug: bool,
    make: Callable[[dict[str, FleetTheme], Drawing, bool], FleetApp],
) -> FleetApp:
    """What `make` makes of themes, the way the map is drawn, and whether there is colour; fit for this
    terminal. Raises FleetError where it can't run."""
    need_terminal()
    themes, problems = load_themes(user_folder() / "themes")
    _refuse(config, themes)
    warnings = [*unsafe_places(config), *(f"theme {problem}" for problem in problems)]
    if log_to_file(debug) is None:
        warnings.append(f"nothing is logged: {state_folder()} can't be written")
    mode, colour = _drawing(drawing or config.ui.drawing), _colour()
    app = make(themes, mode, colour)
    app.main.terminal = _terminal(mode, colour)
    if mode is Drawing.ASCII and not _has_unicode():
        from fleet_tui.terminal.plain_driver import PlainDriver

        app.driver_class = PlainDriver
    for warning in warnings:
        LOG.warning("%s", warning)
    if warnings:
        app.main.said = warnings[0] + (f" and {len(warnings) - 1} more" if warnings[1:] else "")
    return app


def _to_the_end(app: LeanApp) -> None:
    app.run()
    if app.failure is not None:
        raise RuntimeError(app.failure) from app.failure


def _run(app: FleetApp, config: Config, demo: bool) -> None:
    """Run it; the journal is opened after the first picture and before the link."""
    with ExitStack() as until_the_end:

        def open_journal() -> None:
            from fleet_tui.audit.log import auditing
            from fleet_tui.recording.recordings import Recordings

            keeping = auditing(state_folder(), config, app.store, demo)
            app.main.audit = until_the_end.enter_context(keeping)
            app.main.recordings = Recordings(config, app.store, state_folder(), demo)
            until_the_end.callback(app.main.recordings.close)
            app.opening = partial(recorded, app.main.recordings, None if demo else state_folder())

        def pack(shot: str, is_over: Callable[[], bool]) -> Path:
            from fleet_tui.recording.incident import pack

            recent = app.main.recordings.recent() if app.main.recordings is not None else []
            return pack(config, state_folder(), shot, recent, is_over)

        app.main.open_journal, app.main.pack = open_journal, pack
        _to_the_end(app)
