"""The web server for Prometheus."""

import urllib.request

import pytest
from prometheus_client import CollectorRegistry, Gauge

from fleet_tui.features.history.metrics.serving import served
from fleet_tui.text.errors import FleetError


def test_it_answers_and_lets_go_of_its_port() -> None:
    registry = CollectorRegistry()
    Gauge("one", "One", ("of",), registry=registry).labels('a"\n\\b').set(1)
    with served(registry, "127.0.0.1", 0) as address:
        with urllib.request.urlopen(address, timeout=10) as answer:
            text = answer.read().decode()
            assert answer.headers["Content-Type"].startswith("text/plain")
        assert 'one{of="a\\"\\n\\\\b"} 1.0\n' in text
        port = int(address.split(":")[2].partition("/")[0])
        with pytest.raises(FleetError, match="Address already in use: choose another --port"):
            served(registry, "127.0.0.1", port).__enter__()
    with served(registry, "127.0.0.1", port):
        pass


def test_an_address_that_is_not_ours() -> None:
    with pytest.raises(FleetError, match=r"^192\.0\.2\.1:0: "):
        served(CollectorRegistry(), "192.0.2.1", 0).__enter__()
