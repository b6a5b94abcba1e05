"""Collects the history of a site where no console stays open: a service, without a screen, read-only."""

import time
from collections.abc import Callable, Iterable

from fleet_tui.cli.session import WaitingStore, ended_by_signals, only_watching, session
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.records.audit.log import new_origin
from fleet_tui.records.history.notifying import alarm_program
from fleet_tui.records.history.writer import history_of
from fleet_tui.text.errors import ConfigError
from fleet_tui.text.sanitize import sanitize


class Following:
    """Says each link's state once, and again when it changes."""

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say
        self._told: dict[str, str] = {}

    def look(self, state: FleetState, notes: Iterable[str] = ()) -> None:
        """Say what changed since the last call."""
        news = {link.url: _words(link) for link in state.links.values()}
        for name, text in news.items():
            if self._told.get(name) != text:
                self._say(sanitize(f"{name}: {text}"))
        for note in notes:
            if note not in self._told:
                self._say(sanitize(note))
        self._told = {**news, **dict.fromkeys(notes, "")}


def _words(link: LinkState) -> str:
    if link.phase is Phase.UP:
        return "connected"
    return f"no link{': ' if link.reason else ''}{link.reason}"


LOOK_EVERY = 0.5
"""Seconds between two looks at links and disk."""


def collect(config: Config, say: Callable[[str], None]) -> None:
    """Write the history until SIGTERM or Ctrl-C. A lost link is waited for. Raises ConfigError for an unsafe
    secret, or if no history is kept."""
    config = only_watching(config)
    if not config.history.days:
        raise ConfigError([f"{config.path}: history.days is 0: no history is kept"])
    store = WaitingStore(initial_state(config, time.monotonic()))
    following, program = Following(say), alarm_program(config, say)
    with ended_by_signals(), history_of(state_folder(), config, store, new_origin(config)) as history:
        assert history is not None
        say(f"collecting the history in {sanitize(str(history.path))}")
        with session(config, store=store):
            while True:
                following.look(store.state, history.notes)
                if program is not None:
                    program.look(store.state)
                time.sleep(LOOK_EVERY)
