"""What a feature adds to the main screen, which composes a list of them."""

from collections.abc import Callable, Mapping

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.typed import Typed
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay


def _no_loss() -> Message:
    return EMPTY


class Feature(Struct, frozen=True, kw_only=True):
    """`actions` by the id of their key; `overlays` over the map; `typed` parses lines of the palette, each
    None for a line that is not its own; `loss` tells why the console can't be left alone now."""

    actions: Mapping[str, Callable[[], object]] = {}
    overlays: tuple[TableOverlay, ...] = ()
    typed: tuple[Callable[[str], Typed | None], ...] = ()
    loss: Callable[[], Message] = _no_loss
