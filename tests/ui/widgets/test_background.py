"""Work beside the loop: its result arrives on the loop."""

import asyncio
import threading

from textual.app import App

from fleet_tui.ui.widgets.background import run_in_background
from tests.support.polling import HANGS


async def test_the_work_is_done_in_a_thread_and_its_result_on_the_loop() -> None:
    app = App[None]()
    async with app.run_test():
        loop = threading.get_ident()
        done = asyncio.Event()
        threads: list[int] = []

        def then(worker: int) -> None:
            threads.extend((worker, threading.get_ident()))
            done.set()

        run_in_background(app.screen, threading.get_ident, then)
        await asyncio.wait_for(done.wait(), HANGS)
        assert threads[0] != loop and threads[1] == loop
