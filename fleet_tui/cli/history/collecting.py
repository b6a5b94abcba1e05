"""Collects the history of a site where no console stays open: a service, without a screen, read-only."""

import time
from collections.abc import Callable

from fleet_tui.audit.log import new_origin
from fleet_tui.cli.history.following import Following
from fleet_tui.cli.record import ended_by_signals, only_watching
from fleet_tui.cli.session import WaitingStore, session
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.errors import ConfigError
from fleet_tui.history.notifying import alarm_program
from fleet_tui.history.writer import history_of
from fleet_tui.log_file import state_folder
from fleet_tui.text.sanitize import sanitize

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
