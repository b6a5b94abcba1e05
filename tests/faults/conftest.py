"""The short form of the faults, as `make nightly` runs them first: the same, only sooner."""

import os
from pathlib import Path

import pytest

from fleet_tui.links.rosbridge import heartbeat, latched, missing_packages, renewals
from fleet_tui.links.transports.rosbridge import connection
from fleet_tui.simulator.faults import wire, world

SHORT = (
    # Autobahn cuts its times down to whole seconds of the clock: 2 is 1 to 2.
    (connection, {"PING_INTERVAL": 1.0, "PING_TIMEOUT": 2.0, "CONNECT_TIMEOUT": 2.0}),
    (connection, {"FIRST_DELAY": 0.1, "LONGEST_DELAY": 0.4}),
    (heartbeat, {"EVERY": 1.0, "TIMEOUT": 1.0}),
    (renewals, {"FIRST_RENEWAL": 6.0}),
    (latched, {"FIRST_PATIENCE": 0.5}),
    (missing_packages, {"LOOK_AFTER": 2.0}),
    (wire, {"OBEYS": 3.0, "SLOW": 2.0, "AGAIN": 0.3}),
    (world, {"FOREIGN": 1.0, "FOREIGN_PAUSE": 2.0}),
)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.nightly)


@pytest.fixture(autouse=True)
def hurry(monkeypatch: pytest.MonkeyPatch) -> None:
    """Shorter delays, unless it is the true ones that are to be measured."""
    if "FLEET_TUI_FAULTS" not in os.environ:
        for module, delays in SHORT:
            for name, seconds in delays.items():
                monkeypatch.setattr(module, name, seconds)
