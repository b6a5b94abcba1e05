"""Transport orders as a robot reports them."""

from msgspec import Struct

# Both of the first come from the source; the others occur. An unknown letter is shown as it is.
STATUS_WORDS = {"W": "in process", "Q": "queued", "D": "done", "C": "cancelled"}
OPEN_STATUSES = frozenset("WQ")
"""Orders that will still be driven."""


class Order(Struct, frozen=True):
    """Bring cargo from vertex `start` to vertex `end`; `status` is the robot's own letter."""

    id: int
    start: int
    end: int
    status: str

    @property
    def is_over(self) -> bool:
        """Tell whether it is only still listed."""
        return self.status in ("D", "C")


class OrderQueue(Struct, frozen=True):
    """A robot's orders. `current_order_id` means none where no order of the list has it; `request_id` is
    the request that placed the newest order, 0 where the robot does not echo it."""

    last_order_id: int
    current_order_id: int
    orders: tuple[Order, ...]
    request_id: int = 0

    @property
    def current(self) -> Order | None:
        """The order being driven."""
        return next((order for order in self.orders if order.id == self.current_order_id), None)

    @property
    def open(self) -> tuple[Order, ...]:
        """The orders that will still be driven, as far as their letters tell."""
        return tuple(order for order in self.in_sequence() if not order.is_over)

    def in_sequence(self) -> tuple[Order, ...]:
        """The orders as they will be driven: the current one first."""
        current = self.current
        if current is None:
            return self.orders
        return (current, *(order for order in self.orders if order is not current))
