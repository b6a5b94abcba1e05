"""The effects of a key on a console: the parts that a person sees, and presses that must change one."""

from collections.abc import Awaitable, Callable, Collection, Mapping

from fleet_tui.keys import KEYS, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.screens.overlay import Overlay
from tests.support.console_pilot import Console

Part = Callable[[Console], object]
Reset = Callable[[Console], Awaitable[object]]


def overlays(it: Console) -> list[str | None]:
    return [one.id for one in it.app.main.query(Overlay) if one.is_open]


def _diagnostics(it: Console) -> object:
    rows = it.pane("diagnostics-rows").splitlines()
    return it.pane("diagnostics-pages"), it.pane("diagnostics-keys"), rows[:1], overlays(it), focus(it)


def focus(it: Console) -> str | None:
    focused = it.app.main.focused
    return focused.id if focused is not None else None


def _drawing(it: Console) -> object:
    rest = it.app.main.features
    return id(rest.editing.editor.draft), rest.map.picture.options, overlays(it), it.app.main.notices.text


def _placed(it: Console) -> object:
    mode = it.app.main.features.set_up.poses.mode
    return overlays(it), mode and mode.yaw, it.app.main.notices.text


HISTORY_PANES = ("history-pages", "history-rows", "history-keys")

PARTS: Mapping[str, Part] = {
    "overlay": overlays,
    "focus": focus,
    "robot": lambda it: it.app.main.navigation.robot,
    "floor": lambda it: it.app.main.navigation.floor,
    "view": lambda it: it.pane("map"),
    "zoom": lambda it: it.app.main.features.map.picture.viewport.zoom_robot,
    "follow": lambda it: it.app.main.features.map.picture.viewport.follow,
    "options": lambda it: it.app.main.features.map.picture.options,
    "notice": lambda it: it.app.main.notices.text,
    "mode": lambda it: it.app.main.features.map_pane,
    "sent": lambda it: len(it.store.state.commands),
    "alarms": lambda it: it.store.state.unacknowledged,
    "enlarged": lambda it: it.app.main.panes.is_enlarged,
    "simple": lambda it: it.app.main.panes.has_class("-simple"),
    "queue": lambda it: it.pane("queue").splitlines()[0],
    "sorted": lambda it: it.app.main.fleet.arrangement.column,
    "grouped": lambda it: it.app.main.fleet.arrangement.groups.by,
    "marked": lambda it: list(it.app.main.fleet.listing.marks),
    "row": lambda it: it.app.main.fleet.listing.cursor,
    # All columns are visible: rows that are not longer than their pane look the same.
    "slid": lambda it: it.app.main.fleet.listing._slid,
    "answer": lambda it: (it.app.main.features.map_pane, it.app.main.notices.text, overlays(it)),
    "draft": _drawing,
    "place": _placed,
    "diagnostics": _diagnostics,
    "history": lambda it: (*map(it.pane, HISTORY_PANES), overlays(it), focus(it)),
    "time": lambda it: (it.pane("time-line"), overlays(it)),
}


class Presses:
    """Presses keys one after the other, each from the same beginning (`reset`), and sees that each has its
    effect. `others` are parts of one test alone."""

    def __init__(self, it: Console, reset: Reset, others: Mapping[str, Part] | None = None) -> None:
        self._it, self._reset, self._parts = it, reset, {**PARTS, **(others or {})}

    async def each(
        self, panes: Collection[Pane], effects: Mapping[str, str], first: Mapping[str, tuple[str, ...]]
    ) -> None:
        """Press every key of some panes. `effects` names the part that the key of an id changes, `first` the
        keys that are pressed before."""
        keys = [key for key in KEYS if key.pane in panes and key.keys]
        assert {key.id for key in keys} == set(effects), "every key has its effect"
        for key in keys:
            for name in key.keys:
                await self._reset(self._it)
                await self._it.press(*first.get(key.id, ()))
                await self._seen(self._parts[effects[key.id]], name, key.id)

    async def _seen(self, part: Part, name: str, id_: str) -> None:
        self._it.app.main.tick()
        before = part(self._it)
        await self._it.press(name)

        def is_changed(_: FleetState) -> bool:
            self._it.app.main.tick()
            return part(self._it) != before

        try:
            await self._it.until(is_changed)
        except TimeoutError:
            raise AssertionError(f"{name} of {id_} has no effect\n{self._it.text}") from None


async def close_all(it: Console) -> None:
    """Close every overlay, with the focus on the map."""
    while overlays(it):
        await it.press("escape")
    it.app.main.set_focus(it.app.main.features.map)
