"""The `doctor --bundle` option: findings and recordings in one archive."""

import time

from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.records.recording.incident import FOLDER, RECORDING, SPAN, Incident, collect
from fleet_tui.records.recording.recordings import recent_runs
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


def pack(config: Config, report: str, kind: str) -> str:
    """Write the archive; return a line with its path. Raises FleetError."""
    incident = Incident()
    incident.add(f"doctor.{kind}", "doctor report", lambda: report.encode())
    runs = recent_runs(state_folder())
    for name, files in runs.items():
        incident.add_recording(f"{name}.jsonl.gz", files)
    if not runs:
        incident.add_recording(RECORDING, [])
    collect(incident, config, state_folder(), time.time() - SPAN)
    try:
        return f"for the ticket: {incident.write(state_folder() / FOLDER)}"
    except OSError as problem:
        why = f"{problem.strerror or problem} ({state_folder()})"
        raise FleetError(
            Message("cannot write the archive: {why}; set XDG_STATE_HOME to another folder", why=why)
        ) from None
