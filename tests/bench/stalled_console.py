"""The console with a log of its event loop's gaps and of its calls; bench_stall runs it in a pty.

Arguments: the log's path, `lean` or `stock`.
"""

import asyncio
import sys
import time
from pathlib import Path

import fleet_tui
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.console.demo import demo_config, simulated
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.state.store import Store
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing

BEAT = 0.005
ROBOTS = 10


class Watched(FleetApp):
    """Writes a line for every late beat of the loop and every pause sent: what, when, seconds."""

    CSS_PATH = str(Path(fleet_tui.__file__).parent / "fleet.tcss")

    def on_mount(self) -> None:
        send = Connection.send

        def tapped(connection: Connection, payload: bytes) -> None:
            send(connection, payload)
            if b"Pause" in payload:
                self._note("call", 0.0)

        setattr(Connection, "send", tapped)  # noqa: B010  # the one place where a frame leaves us
        self.run_worker(self._beat())

    def _note(self, what: str, seconds: float) -> None:
        with Path(sys.argv[1]).open("a") as log:
            log.write(f"{what} {time.monotonic():.3f} {seconds:.4f}\n")

    async def _beat(self) -> None:
        last = time.monotonic()
        while True:
            await asyncio.sleep(BEAT)
            now = time.monotonic()
            if now - last > BEAT + 0.001:
                self._note("gap", now - last - BEAT)
            last = now


def main() -> None:
    FleetApp.LEAN = sys.argv[2] == "lean"
    with simulated(ROBOTS, 1) as (url,):
        config = demo_config(Config(path=Path("bench")), url, ROBOTS, 1)
        store = Store(initial_state(config, time.monotonic()))
        Watched(config, store, load_themes(None)[0], Drawing.BRAILLE).run()


if __name__ == "__main__":
    main()
