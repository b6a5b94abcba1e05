"""Keys and pages of the diagnostics screen."""

from collections.abc import Callable

from msgspec import Struct

from fleet_tui.actions.panes import DiagnosticsActions
from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message


class DiagnosticsPage(Struct, frozen=True):
    """`text` is the help of a page, `enter` the label of Enter in its last line, `keys` the ids of its keys
    besides those of all pages."""

    text: str
    enter: str = ""
    keys: tuple[str, ...] = ()


PAGES = {
    "Link": DiagnosticsPage("state, round trip, rates, reconnects, drops", "topics"),
    "Topics": DiagnosticsPage(
        "rate, age and errors; Enter shows the last message", "message", ("filter", "copy")
    ),
    "Raw": DiagnosticsPage("the last message of a topic", keys=("freeze", "bad", "copy")),
    "Log": DiagnosticsPage(
        "robot log (/rosout); Enter shows the whole message", "whole", ("filter", "level", "freeze", "copy")
    ),
    "Health": DiagnosticsPage("robot diagnostics (/diagnostics)", "values", ("filter", "copy")),
    "Console": DiagnosticsPage("rendering cost and log of this console", keys=("filter", "copy")),
}
"""The pages of the diagnostics screen, by their names."""


def _page(number: int) -> Callable[[DiagnosticsActions], None]:
    return lambda do: do.page(number)


DIAGNOSTICS: tuple[Key[DiagnosticsActions], ...] = (
    *(
        Key(
            f"page_{name.lower()}",
            (str(n),),
            _page(n),
            Message("Page {n}: {text}", n=n, text=Message(page.text)),
            pane=Pane.DIAGNOSTICS,
        )
        for n, (name, page) in enumerate(PAGES.items(), 1)
    ),
    Key("next_page", ("tab",), lambda do: do.step_page(1), "Next page", pane=Pane.DIAGNOSTICS),
    Key(
        "previous_page",
        ("shift+tab",),
        lambda do: do.step_page(-1),
        "Previous page",
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "filter",
        ("/",),
        lambda do: do.filter(),
        "Filter the rows by text; Enter or Esc leaves the field",
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "freeze",
        ("space", "f"),
        lambda do: do.freeze(),
        "Freeze or resume the message or the robot log",
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "copy",
        ("y",),
        lambda do: do.copy(),
        "Copy the message or the row to the clipboard (OSC 52)",
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "level",
        ("v",),
        lambda do: do.next_level(),
        "Change the lowest level shown in the robot log",
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "bad",
        ("b",),
        lambda do: do.show_bad(),
        "Toggle the raw message: last or last bad",
        pane=Pane.DIAGNOSTICS,
    ),
    Key("leave", ("escape", "q"), lambda do: do.leave(), "Go back one level", pane=Pane.DIAGNOSTICS),
)
