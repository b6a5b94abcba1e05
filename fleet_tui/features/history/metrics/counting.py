"""Events since the start, as Prometheus counters."""

from collections.abc import Iterable

from prometheus_client import CollectorRegistry, Counter, disable_created_metrics

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import ORDER_ENDS, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import OrderChange
from fleet_tui.records.history.observing import Observer

ENDS = frozenset(stage.value for stage in ORDER_ENDS)
FROM_ZERO = (Stage.DONE.value, Stage.LOST.value, Stage.LEFT.value, Stage.FAILED.value)


class Counting:
    """Counts the ends of orders, which the robots show, and the steps of commands, which consoles of this
    machine write into the audit log."""

    def __init__(self, registry: CollectorRegistry) -> None:
        # A further series for each, which nobody asks for.
        disable_created_metrics()  # type: ignore[no-untyped-call]  # has no annotations
        self._observer = Observer()
        self._orders = Counter(
            "fleet_orders", "Orders that ended, by how", ("robot", "outcome"), registry=registry
        )
        self._commands = Counter(
            "fleet_commands", "Stages that commands reached", ("command", "stage"), registry=registry
        )

    def observe(self, state: FleetState) -> None:
        """Count the orders that ended since the last state."""
        for robot in state.robots:
            for (
                outcome
            ) in FROM_ZERO:  # a counter that is born with its first event hides that from Prometheus
                self._orders.labels(robot, outcome)
        for fact in self._observer.observe(state):
            if isinstance(fact, OrderChange) and fact.stage in ENDS:
                self._orders.labels(fact.robot, fact.stage).inc()

    def read(self, state: FleetState, records: Iterable[AuditRecord]) -> None:
        """Count the steps of commands to robots of this fleet."""
        for record in records:
            if record.kind == "command" and record.robot in state.robots and not record.demo:
                self._commands.labels(record.what, record.change).inc()
