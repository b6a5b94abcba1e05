"""The web server that Prometheus asks."""

from collections.abc import Iterator
from contextlib import contextmanager

from prometheus_client import CollectorRegistry, start_http_server

from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message


@contextmanager
def served(registry: CollectorRegistry, host: str, port: int) -> Iterator[str]:
    """Answer HTTP requests in threads; yields the address. Raises FleetError if it can't listen there."""
    try:
        server, thread = start_http_server(port, host, registry)
    except OSError as problem:
        remedy = ": choose another --port" if problem.strerror == "Address already in use" else ""
        raise FleetError(
            Message(
                "{host}:{port}: {strerror}{remedy}",
                host=host,
                port=port,
                strerror=problem.strerror or problem,
                remedy=remedy,
            )
        ) from None
    shown = f"[{host}]" if ":" in host else host
    try:
        yield f"http://{shown}:{server.server_port}/metrics"
    finally:
        server.shutdown()
        server.server_close()
        thread.join(1.0)
