"""Keys and pages of the diagnostics screen."""

from msgspec import Struct

from fleet_tui.keys.key import Key


class DiagnosticsPage(Struct, frozen=True):
    """`text` is what help says of a page, `enter` the word for Enter in its last line, `keys` the ids of the
    keys there beside those of all pages."""

    text: str
    enter: str = ""
    keys: tuple[str, ...] = ()


PAGES = {
    "Link": DiagnosticsPage("is it there, round trip, rates, reconnects, drops", "topics"),
    "Topics": DiagnosticsPage(
        "rate, age, errors of each; Enter shows its last message", "its message", ("filter", "copy")
    ),
    "Raw": DiagnosticsPage("the last message of a topic", keys=("freeze", "bad", "copy")),
    "Log": DiagnosticsPage("what the robots log (/rosout)", keys=("filter", "level", "freeze", "copy")),
    "Health": DiagnosticsPage("what they report of themselves (/diagnostics)", "values", ("filter", "copy")),
    "Console": DiagnosticsPage("what its pictures cost, and its own log", keys=("filter", "copy")),
}
"""The pages of the diagnostics screen, by their names."""

DIAGNOSTICS: tuple[Key, ...] = (
    *(
        Key(f"page_{name.lower()}", (str(n),), f"page({n})", f"Page {n}: {page.text}", pane="diagnostics")
        for n, (name, page) in enumerate(PAGES.items(), 1)
    ),
    Key("next_page", ("tab",), "step_page(1)", "Next page", pane="diagnostics", eager="selects"),
    Key(
        "previous_page", ("shift+tab",), "step_page(-1)", "Previous page", pane="diagnostics", eager="selects"
    ),
    Key(
        "filter",
        ("/",),
        "filter",
        "Filter the rows by text; Enter or Esc leaves it",
        pane="diagnostics",
        eager="opens",
    ),
    Key(
        "freeze",
        ("space", "f"),
        "freeze",
        "Freeze the message or the robots' log, or go on",
        pane="diagnostics",
    ),
    Key(
        "copy",
        ("y",),
        "copy",
        "Copy the message, or the row, to the clipboard (OSC 52)",
        pane="diagnostics",
    ),
    Key(
        "level",
        ("v",),
        "level",
        "Robots' log: all levels, or only the worse ones",
        pane="diagnostics",
    ),
    Key("bad", ("b",), "bad", "Raw: the last message, or the last bad one", pane="diagnostics"),
    Key("leave", ("escape", "q"), "leave", "One level back", pane="diagnostics"),
)
