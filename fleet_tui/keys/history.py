"""Keys and pages of the history."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import N_, Message

HISTORY_PAGES = {
    N_("Events"): Message("orders, alarms, commands, links, notes"),
    N_("Robots"): Message("activity of each robot over time"),
    N_("Batteries"): Message("curves and forecasts"),
    N_("Alarms"): Message("when each was active"),
    N_("Places"): Message("where robots were blocked, on the map"),
}
"""The pages of the history with their contents."""


def _key(id_: str, keys: tuple[str, ...], text: Message) -> Key:
    return Key(f"history_{id_}", keys, text, pane=Pane.HISTORY)


HISTORY: tuple[Key, ...] = (
    *(
        _key(name.lower(), (str(n),), Message("Page {n}: {text}", n=n, text=text))
        for n, (name, text) in enumerate(HISTORY_PAGES.items(), 1)
    ),
    _key("next_page", ("tab",), Message("Next page")),
    _key("previous_page", ("shift+tab",), Message("Previous page")),
    _key("filter", ("/",), Message("Filter: words, !word; a robot, a place, an outcome")),
    _key("earlier", (",",), Message("Earlier, by half the span")),
    _key("later", (".",), Message("Later, up to now")),
    _key("longer", ("-",), Message("Longer span: 15 min, 1 h, 8 h, 24 h, 7 d, 30 d")),
    _key("shorter", ("+",), Message("Shorter span")),
    _key("floor", ("f",), Message("Next floor, on the page of places")),
    _key("replay", ("o",), Message("Open the recording at the marked row, else at the end of the span")),
    _key("leave", ("escape", "q"), Message("Go back")),
)
