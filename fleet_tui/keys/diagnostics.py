"""Keys and pages of the diagnostics screen."""

from msgspec import Struct

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import N_, Message


class DiagnosticsPage(Struct, frozen=True):
    """`text` is the help of a page, `enter` the label of Enter in its last line, `keys` the ids of its keys
    besides those of all pages."""

    text: Message
    enter: str = ""
    keys: tuple[str, ...] = ()


PAGES = {
    N_("Link"): DiagnosticsPage(Message("state, round trip, rates, reconnects, drops"), N_("topics")),
    N_("Topics"): DiagnosticsPage(
        Message("rate, age and errors; Enter shows the last message"),
        N_("message"),
        (N_("filter"), N_("copy")),
    ),
    N_("Raw"): DiagnosticsPage(
        Message("the last message of a topic"), keys=(N_("freeze"), N_("bad"), N_("copy"))
    ),
    N_("Log"): DiagnosticsPage(
        Message("robot log (/rosout); Enter shows the whole message"),
        N_("whole"),
        (N_("filter"), N_("level"), N_("freeze"), N_("copy")),
    ),
    N_("Health"): DiagnosticsPage(
        Message("robot diagnostics (/diagnostics)"), N_("values"), (N_("filter"), N_("copy"))
    ),
    N_("Console"): DiagnosticsPage(
        Message("rendering cost and log of this console"), keys=(N_("filter"), N_("copy"))
    ),
}
"""The pages of the diagnostics screen, by their names."""


DIAGNOSTICS: tuple[Key, ...] = (
    *(
        Key(
            f"page_{name.lower()}",
            (str(n),),
            Message("Page {n}: {text}", n=n, text=page.text),
            pane=Pane.DIAGNOSTICS,
        )
        for n, (name, page) in enumerate(PAGES.items(), 1)
    ),
    Key("next_page", ("tab",), Message("Next page"), pane=Pane.DIAGNOSTICS),
    Key("previous_page", ("shift+tab",), Message("Previous page"), pane=Pane.DIAGNOSTICS),
    Key(
        "filter",
        ("/",),
        Message("Filter the rows by text; Enter or Esc leaves the field"),
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "freeze",
        ("space", "f"),
        Message("Freeze or resume the message or the robot log"),
        pane=Pane.DIAGNOSTICS,
    ),
    Key(
        "copy",
        ("y",),
        Message("Copy the message or the row to the clipboard (OSC 52)"),
        pane=Pane.DIAGNOSTICS,
    ),
    Key("level", ("v",), Message("Change the lowest level shown in the robot log"), pane=Pane.DIAGNOSTICS),
    Key("bad", ("b",), Message("Toggle the raw message: last or last bad"), pane=Pane.DIAGNOSTICS),
    Key("leave", ("escape", "q"), Message("Go back one level"), pane=Pane.DIAGNOSTICS),
)
