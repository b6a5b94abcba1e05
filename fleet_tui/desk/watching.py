"""The claims of a desk for a command without a screen, which is not at the desk itself."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from fleet_tui.config.schema import Config
from fleet_tui.desk.desk import EVERY, colleagues
from fleet_tui.desk.presence import PresenceReader
from fleet_tui.model.desk.events import ColleaguesSeen
from fleet_tui.model.events import Event
from fleet_tui.text.sanitize import sanitize

FIRST_WITHIN = 1.0
"""Seconds to wait for the first look: a folder that does not respond holds no command back."""


@contextmanager
def watched_claims(
    config: Config, post: Callable[[Event], object], say: Callable[[str], object]
) -> Iterator[None]:
    """Post who is at the desk of the configuration, if it has one, while this lasts. Says why claims are not
    known."""
    if not config.desk.folder:
        yield
        return
    folder = config.beside(config.desk.folder)
    reader, looked, closing = PresenceReader(folder), threading.Event(), threading.Event()
    problems: list[str] = []

    def work() -> None:
        while not closing.is_set():
            try:
                post(ColleaguesSeen(colleagues(reader.look())))
            except OSError as problem:
                problems[:] = [f"{problem.strerror or problem}"]
            looked.set()
            closing.wait(EVERY)

    threading.Thread(target=work, name="fleet-tui-desk", daemon=True).start()
    if not looked.wait(FIRST_WITHIN):
        problems[:] = ["not responding"]
    if problems:
        say(sanitize(f"desk: claims unknown: {folder}: {problems[0]}"))
    try:
        yield
    finally:
        closing.set()
