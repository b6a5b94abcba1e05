"""The `record` command: records all received messages, without a screen. Read-only."""

import shlex
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from fleet_tui.cli.session import WaitingStore, ended_by_signals, has_link, only_watching, session
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.maps.floor_files import load_maps
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.records.audit.log import new_origin
from fleet_tui.records.history.writer import history_of
from fleet_tui.records.recording.part_files import PartLimits
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.taps import Taps
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age

FINE = 0
NO_LINK = 3
LOOK_EVERY = 0.25
SHOW_EVERY = 1.0
"""Seconds between checks of the progress, and until the line on a terminal is written again."""
MAP_WITHIN = 20.0
"""Maximum seconds for a live map before the next one is requested."""

Say = Callable[[str], None]


class _Watch:
    """Prints changes, and the progress on a terminal."""

    def __init__(self, recorder: Recorder, say: Say, is_live: bool) -> None:
        self._recorder = recorder
        self._say = say
        self._is_live = is_live
        self._links: dict[str, str] = {}
        self._problem = ""
        self._counted = 0
        self._written = 0
        self._shown_at = time.monotonic()
        self.had_link = False

    def look(self, state: FleetState) -> None:
        """Print changes."""
        self.had_link = self.had_link or has_link(state)
        for link in state.links.values():
            up = link.phase is Phase.UP
            message = "up" if up else f"no link{': ' if link.reason else ''}{link.reason}"
            if self._links.get(link.name) != message and (up or link.reason):
                self._links[link.name] = message
                self._line(f"{link.url}: {message}")
        problem = self._recorder.problem
        if problem != self._problem:
            self._problem = problem
            self._line(f"recording stopped: {problem}" if problem else "recording resumed")
        if self._is_live and time.monotonic() - self._shown_at >= SHOW_EVERY:
            self._show(state)

    def _line(self, text: str) -> None:
        if self._is_live:
            sys.stderr.write("\r\x1b[K")
        self._say(sanitize(text))

    def _show(self, state: FleetState) -> None:
        """Print a line that is overwritten later."""
        recorder, now = self._recorder, time.monotonic()
        passed = now - self._shown_at
        rate, flow = (recorder.records - self._counted) / passed, (recorder.size - self._written) / passed
        self._counted = recorder.records
        self._written = recorder.size
        self._shown_at = now
        online = sum(map(state.is_online, state.robots.values()))
        size = f"{recorder.size / 1e6:.1f} MB ({flow / 1e3:.0f} kB/s)"
        text = (
            f"{age(now - recorder.began)}, {online} of {len(state.robots)} robots online, "
            f"{recorder.records:,} records ({rate:.0f}/s), {size}"
        )
        sys.stderr.write(f"\r{text[:79]}\x1b[K")
        sys.stderr.flush()

    def close(self, state: FleetState) -> None:
        """Print the result."""
        self.look(state)
        recorder, files = self._recorder, len(self._recorder.paths)
        size = f"{recorder.size / 1e6:.1f} MB in {files} file{'s' * (files != 1)}"
        self._line(f"{recorder.records:,} records, {size}")


def _load_maps(config: Config, link: FleetLink) -> None:
    for loaded in load_maps(config):
        link.post(loaded)


def _has_no_map(state: FleetState, robot: str, floor: str) -> bool:
    return state.robots[robot].maps[floor].grid is None and state.floors[floor].live is None


def _live_maps(config: Config, store: WaitingStore, link: FleetLink) -> Iterator[None]:
    """Request one live map after the other, of each floor without a file: so a replay can show it."""
    for floor in [floor.name for floor in config.floors if not floor.map]:
        robot = next((robot.name for robot in config.robots if floor in config.floors_of(robot)), "")
        until = time.monotonic() + MAP_WITHIN
        while robot and not has_link(store.state):
            until = time.monotonic() + MAP_WITHIN
            yield
        if robot:
            link.show_map(robot, floor)
        while robot and _has_no_map(store.state, robot, floor) and time.monotonic() < until:
            yield
    link.show_map(config.robots[0].name, "")


def record(
    config: Config, path: Path, limits: PartLimits, seconds: float, timeout: float, say: Say, is_live: bool
) -> int:
    """Record for a number of seconds, until SIGTERM or Ctrl-C; return the exit code. Without a link within
    `timeout` seconds it ends. Raises RecordingError if the file can't be created, ConfigError for an
    unsafe secret."""
    config = only_watching(config)
    store = WaitingStore(initial_state(config, time.monotonic()))
    taps, origin = Taps(), new_origin(config)
    recorder = taps.attach(Recorder(path, config, store, origin, limits))
    shown = sanitize(str(path))
    say(f"recording to {shown}; replay with: fleet-tui replay {shlex.quote(shown)}")
    watch = _Watch(recorder, say, is_live)
    with ended_by_signals():
        try:
            with history_of(state_folder(), config, store, origin), session(config, taps, store) as (link, _):
                _load_maps(config, link)
                maps = _live_maps(config, store, link)
                while _goes_on(recorder.began, seconds, timeout, watch):
                    next(maps, None)
                    watch.look(store.state)
                    time.sleep(LOOK_EVERY)
        finally:
            taps.detach(recorder)
            watch.close(store.state)
    return FINE if watch.had_link else NO_LINK


def _goes_on(began: float, seconds: float, timeout: float, watch: _Watch) -> bool:
    passed = time.monotonic() - began
    return passed < seconds and (watch.had_link or passed < timeout)
