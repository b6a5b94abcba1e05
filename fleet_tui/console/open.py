"""Opens the console: terminal capabilities, themes, log, then the app."""

import asyncio
import logging
import os
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import msgspec

from fleet_tui.config.access import access_problems
from fleet_tui.config.check import checked
from fleet_tui.config.fleet import watching
from fleet_tui.config.load import looked_for, user_folder
from fleet_tui.config.log_file import log_to_file, state_folder, state_problem
from fleet_tui.config.saving import Saving
from fleet_tui.config.schema import Config, Ui
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.keys.key import key_name
from fleet_tui.keys.keymap import keymap
from fleet_tui.maps.draft_file import draft_of
from fleet_tui.records.audit.elsewhere import watched_commands
from fleet_tui.records.audit.log import auditing, operator_name
from fleet_tui.records.recording.incident import pack as pack_incident
from fleet_tui.state.store import Store
from fleet_tui.text.errors import ConfigError, did_you_mean
from fleet_tui.text.language import EMPTY, Message, counted, joined
from fleet_tui.ui.backend import LiveBackend, OpenLinks, connect_live
from fleet_tui.ui.controllers.files import IN_A_TAB, READ_ONLY, ConsoleFiles
from fleet_tui.ui.languages import use_language
from fleet_tui.ui.terminal.detect import (
    IN_BROWSER,
    description,
    drawing_for,
    has_colour,
    has_unicode,
    need_terminal,
)
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.terminal.terminal_driver import PlainDriver
from fleet_tui.ui.themes import FleetTheme, load_themes
from fleet_tui.ui.view.map.drawing import Drawing

if TYPE_CHECKING:
    from fleet_tui.console.entry import Chosen
    from fleet_tui.links.discovery.site import DiscoveredSite
    from fleet_tui.records.recording.play.player import Player
    from fleet_tui.records.recording.recordings import Recordings
    from fleet_tui.robots.vda5050.discovery import SeenVehicle

LOG = logging.getLogger(__name__)


def _refuse(config: Config, themes: Mapping[str, FleetTheme]) -> None:
    """Raise ConfigError for problems that would only show on the open screen."""
    refused = access_problems(config)
    if config.ui.theme not in themes:
        near = did_you_mean(config.ui.theme, themes)
        refused.append(
            Message("ui.theme: unknown theme {theme}{near}", theme=f"{config.ui.theme!r}", near=near)
        )
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
    """Run the console until the operator leaves. Actions in a `demo` are marked in the audit log; `site`: the
    source of a configuration without a file."""
    saving = None if demo else Saving(config, site)
    if read_only:
        config = watching(config)
    store = Store(initial_state(config, time.monotonic()))
    arrived = _first_steps(config) if demo else _arrived(config, site)
    with ExitStack() as until_the_end:
        files = _files(config, store, demo, saving, until_the_end)
        connect = partial(_connect, files, None if demo else state_folder(), site, until_the_end)
        backend = LiveBackend(config, store, connect)
        until_the_end.enter_context(watched_commands(state_folder(), store, backend.post))
        make = partial(FleetApp, config, store, backend=backend, files=files)
        _to_the_end(_ready(config, drawing, debug, make, arrived))


def _first_steps(config: Config) -> Message:
    """Return what a newcomer to the simulated fleet can try: its floors have these places."""
    if config.operator.read_only:
        return Message("simulated fleet, read-only")
    order, *_ = keymap(config.keys)[0]["order"]
    return Message(
        "simulated fleet. Try an order: {key_name}, type Base, Enter, type Cons, Enter",
        key_name=key_name(order),
    )


def _arrived(config: Config, site: "DiscoveredSite | None") -> Message:
    """Return where the fleet comes from. A file found in the current folder may be there by chance."""
    masters = [name for name, link in config.bridges.items() if link.role == "master"]
    if masters and not config.operator.read_only:
        return Message(
            "master control on {masters}: routes from the graph, no traffic control",
            masters=", ".join(masters),
        )
    if site is not None:
        return Message("{shown}: {summary}. :save keeps it", shown=site.bridge.shown, summary=site.summary)
    count = len(config.robots)
    told = counted("{count} robot", "{count} robots", count)
    if config.path.parent != Path.cwd():
        return Message("{path}: {told}", path=config.path, told=told)
    return Message(
        "./{name}: {problem}. fleet-tui demo shows a simulated fleet", name=config.path.name, problem=told
    )


def _files(
    config: Config, store: Store, demo: bool, saving: Saving | None, until_the_end: ExitStack
) -> ConsoleFiles:
    """Return the files of a live console; `until_the_end` closes them."""

    def open_them(files: ConsoleFiles) -> None:
        from fleet_tui.records.desk.desk import desk_of
        from fleet_tui.records.history.writer import history_of
        from fleet_tui.records.recording.recordings import Recordings

        files.audit = until_the_end.enter_context(auditing(state_folder(), config, store, demo))
        origin = files.audit.origin
        files.history = until_the_end.enter_context(history_of(state_folder(), config, store, origin))
        files.desk = until_the_end.enter_context(desk_of(config, store, origin.operator))
        files.recordings = Recordings(config, store, state_folder(), demo)
        until_the_end.callback(files.recordings.close)

    def pack(shot: str, is_over: Callable[[], bool]) -> Path:
        recent = files.recordings.recent() if files.recordings is not None else []
        return pack_incident(config, state_folder(), shot, recent, is_over)

    def graph_file(floor: str) -> Path | None:
        named = next((one.graph for one in config.floors if one.name == floor), "")
        return config.beside(named) if named else None

    drafts = partial(draft_of, state_folder(), config, demo)
    files = ConsoleFiles(open_them, pack, saving, drafts, graph_file, state_folder())
    files.refusal = READ_ONLY if config.operator.read_only else EMPTY
    files.naming_refusal = files.refusal or (IN_A_TAB if IN_BROWSER in os.environ else EMPTY)
    return files


def _connect(
    files: ConsoleFiles,
    folder: Path | None,
    site: "DiscoveredSite | None",
    until_the_end: ExitStack,
    config: Config,
    store: Store,
    on_ready: Callable[[OpenLinks], None],
) -> None:
    """Connect to the fleet once the files are open. On the address of a broker, add later vehicles."""
    assert files.recordings is not None

    def ready(links: OpenLinks) -> None:
        on_ready(links)
        if files.desk is not None:
            files.desk.start(links.post)
        if site is not None and site.bridge.is_broker:
            from fleet_tui.links.discovery.vehicles import watch_vehicles
            from fleet_tui.links.transports.loop import network_loop

            add = LaterVehicles(files, config, links).add
            watch = asyncio.run_coroutine_threadsafe(watch_vehicles(site.bridge, add), network_loop())
            until_the_end.callback(watch.cancel)

    recorded(files.recordings, folder, config, store, ready)


class LaterVehicles:
    """Adds the vehicles that appear on a broker to a console that was opened on its address."""

    def __init__(self, files: ConsoleFiles, config: Config, links: OpenLinks) -> None:
        self._files = files
        self._config = config
        self._links = links

    def add(self, vehicles: "Sequence[SeenVehicle]") -> None:
        """Add those that are not known, and their maps as floors. Not on the loop."""
        from fleet_tui.links.discovery.vehicles import with_vehicles

        config = with_vehicles(self._config, vehicles)
        if config == self._config:
            return
        if problems := checked(config):
            LOG.warning("vehicles not added: %s", problems[0])
            return
        assert self._files.recordings is not None
        self._files.recordings.extend(config, partial(self._links.extend, config))
        if self._files.saving is not None:
            self._files.saving.extend(config)
        self._config = config


def ask_first(site: "DiscoveredSite | None", drawing: str | None) -> "Chosen":
    """Run the screens before the console: uncertain settings of a site, or the choice of a fleet."""
    from fleet_tui.console.entry import EntryApp

    theme = load_themes(user_folder() / "themes")[0][Ui().theme]
    app = EntryApp(theme, has_colour(), site, looked_for())
    if drawing_for(drawing or Ui().drawing) is Drawing.ASCII and not has_unicode():
        app.driver_class = PlainDriver
    _to_the_end(app)
    return app.chosen


def recorded(
    recordings: "Recordings",
    folder: Path | None,
    config: Config,
    store: Store,
    on_ready: Callable[[OpenLinks], None],
) -> None:
    """Connect to the fleet and record its traffic. `folder` keeps the orders."""

    def keep(links: OpenLinks) -> None:
        on_ready(links)
        recordings.keep_recent()

    connect_live(config, store, keep, recordings.taps, folder, operator_name(config))


def open_replay(config: Config, player: "Player", drawing: str | None, debug: bool) -> None:
    """Run the console on a recording, without a link, an audit log or a bell."""
    make = partial(replaying, config, player, Store(player.state))
    _to_the_end(_ready(config, drawing, debug, make))


def replaying(
    config: Config,
    player: "Player",
    store: Store,
    themes: dict[str, FleetTheme],
    mode: Drawing,
    *,
    colour: bool = True,
    terminal: str = "",
    message: Message = EMPTY,
) -> FleetApp:
    """Return the app on a recording: nothing is sent, and no alarm calls."""
    from fleet_tui.features.recording.replay import Replay
    from fleet_tui.records.recording.play.backend import ReplayBackend

    replace = msgspec.structs.replace
    config = replace(
        config,
        operator=replace(config.operator, read_only=True),
        alarms=replace(config.alarms, bell=[], notify=[]),
    )
    return FleetApp(
        config,
        store,
        themes,
        mode,
        colour=colour,
        backend=ReplayBackend(player, store),
        open_session=partial(Replay, player),
        terminal=terminal,
        message=message,
    )


class _Make(Protocol):
    def __call__(
        self,
        themes: dict[str, FleetTheme],
        drawing: Drawing,
        /,
        *,
        colour: bool,
        terminal: str,
        message: Message,
    ) -> FleetApp: ...


def _ready(
    config: Config, drawing: str | None, debug: bool, make: _Make, message: Message = EMPTY
) -> FleetApp:
    """Return the result of `make` for the themes, the drawing of the map, and whether there is colour;
    adapted to this terminal. Raises FleetError if it can't run."""
    need_terminal()
    themes, problems = load_themes(user_folder() / "themes")
    _refuse(config, themes)
    warnings = [
        *config.withheld,
        *(Message("theme {problem}", problem=Message(problem)) for problem in problems),
    ]
    if log_to_file(debug) is None:
        warnings.append(
            state_problem()
            or Message("logging off: {state_folder} is not writable", state_folder=state_folder())
        )
    for warning in warnings:
        LOG.warning("%s", warning)
    more = Message(" and {count} more", count=len(warnings) - 1) if warnings[1:] else EMPTY
    message = joined("; ", [*(one + more for one in warnings[:1]), *filter(None, [message])])
    use_language(config.ui.language)
    mode, colour = drawing_for(drawing or config.ui.drawing), has_colour()
    app = make(themes, mode, colour=colour, terminal=description(mode, colour), message=message)
    if mode is Drawing.ASCII and not has_unicode():
        app.driver_class = PlainDriver
    return app


def _to_the_end(app: LeanApp) -> None:
    app.run()
    if app.failure is not None:
        raise RuntimeError(app.failure) from app.failure
