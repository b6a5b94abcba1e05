"""The web server that Prometheus asks."""

from collections.abc import Iterator
from contextlib import contextmanager

from prometheus_client import CollectorRegistry, start_http_server

from fleet_tui.errors import FleetError


@contextmanager
def served(registry: CollectorRegistry, host: str, port: int) -> Iterator[str]:
    """Answer HTTP requests in threads; yields the address. Raises FleetError if it can't listen there."""
    try:
        server, thread = start_http_server(port, host, registry)
    except OSError as problem:
        remedy = ": choose another --port" if problem.strerror == "Address already in use" else ""
        raise FleetError(f"{host}:{port}: {problem.strerror or problem}{remedy}") from None
    shown = f"[{host}]" if ":" in host else host
    try:
        yield f"http://{shown}:{server.server_port}/metrics"
    finally:
        server.shutdown()
        server.server_close()
        thread.join(1.0)
