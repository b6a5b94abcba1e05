"""Work in a thread, beside the loop."""

from collections.abc import Callable
from typing import Any

from textual.widget import Widget


def run_in_background(widget: Widget, work: Callable[[], object], then: Callable[[Any], None]) -> None:
    """Do work in a thread, then call with its result on the loop."""

    def run() -> None:
        result = work()
        widget.app.call_from_thread(then, result)

    widget.run_worker(run, thread=True, exit_on_error=False)
