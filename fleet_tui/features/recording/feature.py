from collections.abc import Callable
from functools import partial

from textual.screen import Screen
from textual.worker import get_current_worker

from fleet_tui.features.recording.incident import Cancelled, IncidentPacking
from fleet_tui.features.recording.switch import RecordingSwitch
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.feature import Feature


def recording_feature(console: Console, screen: Screen[None]) -> Feature:
    def in_thread(work: Callable[[Cancelled], None]) -> None:
        def run() -> None:
            worker = get_current_worker()
            work(lambda: worker.is_cancelled)

        screen.run_worker(run, thread=True, exit_on_error=False)

    recording = RecordingSwitch(console, partial(screen.run_worker, thread=True))
    incident = IncidentPacking(console, partial(screen.app.export_screenshot, title="fleet-tui"), in_thread)
    return Feature(actions={"record": recording.turn, "bundle": incident.pack})
