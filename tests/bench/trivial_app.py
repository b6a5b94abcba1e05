"""The least that Textual can be asked to show; bench_start compares the console with it."""

from textual.app import App, ComposeResult
from textual.widgets import Static


class Trivial(App[None]):
    BINDINGS = [("q", "quit", "Leave")]  # noqa: RUF012  # as Textual declares it

    def compose(self) -> ComposeResult:
        yield Static("hello")


if __name__ == "__main__":
    Trivial().run()
