"""The progress of a routine in the state folder: after a crash or a lost link it is resumed from there."""

import hashlib
from pathlib import Path

import msgspec

from fleet_tui.config.small_file import read_text
from fleet_tui.features.routines.files import RoutineFile
from fleet_tui.features.routines.lane import Gate, Lane, LanePhase
from fleet_tui.storage.whole_file import write_whole
from fleet_tui.text.errors import RoutineError
from fleet_tui.text.language import Message, as_written, in_english

LARGEST = 10_000_000


class RoutineProgress(msgspec.Struct, frozen=True):
    """The progress of each robot, for the file of a `digest`. `started` and `at`: Unix seconds of the start
    and of the last change; `operator`: who started it."""

    digest: str
    lanes: tuple[Lane, ...]
    started: float
    at: float
    operator: str = ""

    @property
    def is_over(self) -> bool:
        """Tell whether every lane has ended."""
        return all(lane.is_over for lane in self.lanes)


def progress_path(folder: Path, routine: Path) -> Path:
    """Return the file for the progress of a routine: two sites may have routines of one name."""
    return folder / f"{routine.stem}-{hashlib.sha256(str(routine).encode()).hexdigest()[:8]}.json"


def save_progress(path: Path, progress: RoutineProgress) -> None:
    """Write the progress. Raises OSError."""
    path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
    write_whole(path, msgspec.json.encode(progress, enc_hook=in_english))


def load_progress(path: Path) -> RoutineProgress | None:
    """Return the progress, None if there is none that can be read."""
    try:
        return msgspec.json.decode(read_text(path, LARGEST), type=RoutineProgress, dec_hook=as_written)
    except (OSError, ValueError, msgspec.MsgspecError):
        return None


def resumable(path: Path, file: RoutineFile) -> RoutineProgress:
    """Return the progress to resume. Raises RoutineError if there is none for this file as it is now."""
    progress = load_progress(path)
    if progress is None or progress.is_over:
        raise RoutineError(Message("{name} has nothing to resume: run it without --resume", name=file.name))
    if progress.digest != file.digest:
        raise RoutineError(
            Message("{name} was changed since it was held: start it again, without --resume", name=file.name)
        )
    return progress


def resumed(lane: Lane) -> Lane:
    """Return a lane of an earlier process, held. A program ended with that process; a wait begins again."""
    if lane.is_over:
        return lane
    detail = (
        lane.detail
        if lane.gate is Gate.HELD and lane.detail
        else Message("the process that ran it has ended")
    )
    phase = LanePhase.READY
    if lane.phase is LanePhase.ORDERED and lane.order_id:
        phase = LanePhase.ORDERED
    elif lane.phase is LanePhase.ORDERED:
        detail = Message("an order was sent, and may be carried out: look at the queue first")
    return msgspec.structs.replace(lane, phase=phase, gate=Gate.HELD, detail=detail)
