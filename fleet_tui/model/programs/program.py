"""The state of one program of a robot server, as far as it is known."""

from enum import Enum

from msgspec import Struct

from fleet_tui.text.language import EMPTY, N_, Message

OLD = 20.0
"""Seconds after which a state is no longer known: more than two looks at a host that hangs."""


class ProgramState(Enum):
    """States of a program, by the words on the screen."""

    RUNNING = N_("running")
    STARTING = N_("starting")
    STOPPING = N_("stopping")
    STOPPED = N_("stopped")
    FAILED = N_("failed")
    UNKNOWN = N_("unknown")


ENDED = (ProgramState.STOPPED, ProgramState.FAILED)


class ProgramStatus(Struct, frozen=True):
    """One look at a program. `at`: seconds of the monotonic clock; `since`: Unix seconds by the clock of its
    host; `instance` differs from one start to the next; `dependents`: units that stop with it; `detail`: the
    reason of a failure, with a remedy. None and empty where it is not told."""

    state: ProgramState
    at: float = 0.0
    since: float | None = None
    restarts: int | None = None
    instance: str = ""
    dependents: tuple[str, ...] = ()
    detail: Message = EMPTY
    has_systemd: bool = True


class ProgramRow(Struct, frozen=True):
    """A program with the newest look at it, and the last state that was known; `pending`: the change that is
    under way."""

    name: str
    host: str = ""
    needs: tuple[str, ...] = ()
    status: ProgramStatus | None = None
    last_known: ProgramStatus | None = None
    pending: Message = EMPTY

    def state(self, now: float) -> ProgramState:
        """Return the state, unknown once the last look is too old."""
        if self.status is None or now - self.status.at > OLD:
            return ProgramState.UNKNOWN
        return self.status.state

    def known(self, now: float) -> ProgramStatus | None:
        """Return the newest look unless it is too old or failed."""
        return None if self.state(now) is ProgramState.UNKNOWN else self.status


class ChangeOutcome(Struct, frozen=True):
    """The end of a start, stop or restart: `word` is confirmed, refused, failed or not confirmed."""

    word: Message
    detail: Message = EMPTY

    @property
    def is_confirmed(self) -> bool:
        """Tell whether the program's state shows it."""
        return self.word == CONFIRMED

    @property
    def text(self) -> Message:
        """Return the outcome in words."""
        return Message("{word} ({text})", word=self.word, text=self.detail) if self.detail else self.word


CONFIRMED = Message("confirmed")
REFUSED = Message("refused")
FAILED = Message("failed")
NOT_CONFIRMED = Message("not confirmed")
