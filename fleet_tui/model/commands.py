"""What an operator may ask of a robot, and how each wish ended."""

from dataclasses import dataclass
from enum import Enum

INT32_MAX = 2**31 - 1


@dataclass(frozen=True, slots=True)
class PlaceOrder:
    """Carry from vertex `start` to vertex `end`."""

    robot: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class PlaceOrderWithCargo:
    """Bring the cargo on board to vertex `end`."""

    robot: str
    end: int


@dataclass(frozen=True, slots=True)
class CancelOrder:
    """Take one order out of the queue. `order_id` is above 0: 0 would mean all of them."""

    robot: str
    order_id: int


@dataclass(frozen=True, slots=True)
class ClearOrders:
    """Take every order out of the queue."""

    robot: str


@dataclass(frozen=True, slots=True)
class PauseRobot:
    """Stand still until resumed."""

    robot: str


@dataclass(frozen=True, slots=True)
class ResumeRobot:
    """Go on after a pause."""

    robot: str


Command = PlaceOrder | PlaceOrderWithCargo | CancelOrder | ClearOrders | PauseRobot | ResumeRobot


class Outcome(Enum):
    """How a command ended; the value is the word the operator reads."""

    ACCEPTED = "accepted"
    REFUSED = "refused"
    NO_ANSWER = "no answer"
    UNKNOWN = "outcome unknown"
    NOT_SENT = "not sent"


@dataclass(frozen=True, slots=True)
class CommandRecord:
    """One command from the key to its end. `issued_at` is monotonic, `wall` is Unix seconds;
    `words` are the robot's own, or the reason why nothing was sent; `ended_at` is monotonic too."""

    id: int
    command: Command
    issued_at: float
    wall: float
    outcome: Outcome | None = None
    words: str = ""
    ended_at: float | None = None
