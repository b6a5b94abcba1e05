"""`fleet-tui metrics`: the fleet for Prometheus, without a screen, read-only."""

import logging
import time
from collections.abc import Callable
from contextlib import closing

from prometheus_client import CollectorRegistry

from fleet_tui.cli.session import ended_by_signals, only_watching, session
from fleet_tui.config.log_file import state_folder
from fleet_tui.config.schema import Config
from fleet_tui.features.history.cli.collecting import Following
from fleet_tui.features.history.metrics.collector import FleetCollector
from fleet_tui.features.history.metrics.counting import Counting
from fleet_tui.features.history.metrics.serving import served
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.file import FILE_NAME
from fleet_tui.records.audit.tail import AuditTail
from fleet_tui.text.sanitize import sanitize

LOG = logging.getLogger(__name__)
LOOK_EVERY = 1.0
"""Seconds between two looks at the fleet and the audit log, whose events are counted."""


def metrics(config: Config, host: str, port: int, say: Callable[[str], None]) -> None:
    """Answer until SIGTERM or Ctrl-C. A lost link is waited for. Raises ConfigError for an unsafe secret,
    FleetError if it can't listen."""
    config = only_watching(config)
    registry = CollectorRegistry()
    counting, following = Counting(registry), Following(say)
    with (
        ended_by_signals(),
        closing(AuditTail(state_folder() / FILE_NAME)) as log,
        session(config) as (link, store),
    ):
        registry.register(FleetCollector(lambda: store.state, lambda: link.counters))
        with served(registry, host, port) as address:
            say(f"metrics for Prometheus at {sanitize(address)}")
            while True:
                following.look(store.state)
                counting.observe(store.state)
                counting.read(store.state, _new(log))
                time.sleep(LOOK_EVERY)


def _new(log: AuditTail) -> list[AuditRecord]:
    """Return the new records; none while the log can't be read, which is logged."""
    try:
        return list(log.new())
    except OSError as problem:
        LOG.warning("audit log: %s", problem.strerror)
        return []
