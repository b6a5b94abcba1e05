"""The simple interface, above the map, beside it or in its place: large buttons, for arrows or the mouse."""

from collections.abc import Callable, Sequence
from typing import Any, ClassVar, Self

from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widget import Widget
from textual.widgets import Button, Input, Static

from fleet_tui.commands.language.lookup import HERE, Place, is_still, matches, order_of, places, starts_here
from fleet_tui.model.kind import ORDER
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.ordering.choices import changed, hindrance
from fleet_tui.ui.screens.ordering.form import is_same, picture_of
from fleet_tui.ui.screens.overlay import OnceButton
from fleet_tui.ui.view.tables.doing import told_text
from fleet_tui.ui.widgets.field import Field
from fleet_tui.ui.widgets.matches import Matches
from fleet_tui.ui.widgets.panes import Panes

FIELDS = ("robot", "from", "to", "send")


_PURPOSE = {"from": Message("the cargo is fetched"), "to": Message("it is brought")}
"""Why a choice is missing."""


class Large(OnceButton):
    """A button that acts at once: the next key goes to the result."""

    def __init__(self, label: str, field: str, pressed: Callable[[str], None], **options: Any) -> None:
        super().__init__(label, id=f"simple-{field}", **options)
        self._pressed = pressed
        self._field = field

    def press(self) -> Self:
        """Press, by Enter or by mouse."""
        if self.display:
            self._pressed(self._field)
        return self


class Simple(Vertical):
    """One large button for each choice; a press replaces the buttons by a list, which filters as one types.
    The robot is the console's selected one; `close` returns to the map."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("down,j", "step(1)", "Down"),
        ("up,k", "step(-1)", "Up"),
        ("right", "step(1)", "Right"),
        ("left", "step(-1)", "Left"),
        ("escape", "back", "Back"),
    ]

    def __init__(self, console: Console, close: Callable[[], None]) -> None:
        super().__init__(id="simple")
        self._close = close
        self._store = console.store
        self._navigation = console.navigation
        self._give = console.dispatch.give
        self._chosen: dict[str, Place] = {}
        self._whose = ""
        self._choosing = ""
        self._picture = picture_of(self._store.state, None)
        self._shown: tuple[object, ...] = ()
        self._list = Matches[Place | str](id="simple-list")
        self._typed = Field(
            {
                "enter": self._take,
                "escape": self.action_back,
                "up": lambda: self._list.step(-1),
                "down": lambda: self._list.step(1),
            },
            id="simple-typed",
            placeholder=tr("type to search"),
        )

    def compose(self) -> ComposeResult:
        """Compose the four buttons, a note on missing input, and the list that replaces them."""
        for field in FIELDS[:3]:
            yield Large("", field, self._ask)
        yield Large(tr("Send"), "send", self._finish, variant="primary")
        yield Static(id="simple-missing", markup=False)
        yield Static(id="simple-question", markup=False)
        yield self._typed
        yield self._list

    def show(self) -> None:
        """Update the form: another robot may be selected, and what was chosen may have changed."""
        robot = self._robot()
        picture = picture_of(self._store.state, robot)
        if robot.name != self._whose:
            self._whose = robot.name
            self._picture = picture
            self._forget()
        elif not is_same(picture, self._picture):
            self._picture = picture
            gone = [name for name, place in self._chosen.items() if not self._holds(robot, place)]
            names = [self._chosen.pop(name).name for name in gone]
            if self._choosing and not self._renew():
                names.append(self._typed.value)
            if any(names):
                self._say(changed([name for name in names if name]))
        start = HERE.name if starts_here(robot) else tr("choose ...")
        to = tr("To, for the cargo on board: ") if self._brings(robot) else tr("To: ")
        does = told_text(self._store.state, robot)
        shown = (robot.name, does, start, to, self._choosing, *self._chosen.items())
        if shown == self._shown:
            return
        self._shown = shown
        names_of = {field: sanitize(place.name) for field, place in self._chosen.items()}
        # As Content: a label from the wire is text, whatever markup it looks like.
        self._button("robot").label = Content(tr("Robot: {name}", name=sanitize(robot.name)) + f", {does}")
        self._button("from").label = Content(tr("From: {place}", place=names_of.get("from", start)))
        self._button("to").label = Content(to + names_of.get("to", tr("choose ...")))
        self._button("send").variant = "default" if self._missing() else "primary"
        for field in FIELDS:
            self._button(field).display = not self._choosing
        self.set_class(not self._choosing, "-buttons")
        self.query_one("#simple-missing").display = not self._choosing
        for part in (self.query_one("#simple-question"), self._typed, self._list):
            part.display = bool(self._choosing)

    def start(self) -> None:
        """Show it with nothing chosen, and the focus on the first choice to make."""
        self._forget()
        self._say(EMPTY)
        self.show()
        self._go_on()

    def _forget(self) -> None:
        self._chosen.clear()
        self._choosing = ""

    def _button(self, field: str) -> Button:
        return self.query_one(f"#simple-{field}", Button)

    def _robot(self) -> Robot:
        return self._store.state.robots[self._navigation.robot]

    def _brings(self, robot: Robot) -> bool:
        """Tell whether the order is for the cargo on board."""
        return robot.kind.brings_cargo and starts_here(robot) and self._chosen.get("from", HERE) == HERE

    def _holds(self, robot: Robot, place: Place) -> bool:
        return starts_here(robot) if place == HERE else is_still(robot, place)

    def _say(self, text: Message) -> None:
        note = self.query_one("#simple-missing", Static)
        note.set_class(bool(text), "-missing")
        note.update(translate(text) or tr("Esc: back to the map"))

    def _missing(self) -> str:
        """Return the first field without a choice, empty if all have one."""
        fields = ("to",) if starts_here(self._robot()) else ("from", "to")
        return next((field for field in fields if field not in self._chosen), "")

    def _go_on(self) -> None:
        self.screen.set_focus(self._button(self._missing() or "send"))

    def action_step(self, step: int) -> None:
        """Focus the next visible button."""
        buttons = [button for button in self.query(Button) if button.display]
        if self.screen.focused in buttons:
            at = buttons.index(self.screen.focused)
            self.screen.set_focus(buttons[max(0, min(at + step, len(buttons) - 1))])

    def action_back(self) -> None:
        """Return to the buttons without a choice, from them to the map."""
        field = self._choosing
        if not field:
            self._forget()
            self._close()
            return
        self._choosing = ""
        self.show()
        self.screen.set_focus(self._button(field))

    def _ask(self, field: str) -> None:
        """Show the list of choices."""
        robot = self._robot()
        if field != "robot" and not places(robot):
            self._say(
                hindrance(self._store.state, robot)
                or Message("no places of {name} received yet", name=robot.name)
            )
            return
        self._choosing = field
        with self._typed.prevent(Input.Changed):
            self._typed.value = ""
        self._fill()
        question = {"robot": tr("Which robot?"), "from": tr("From where?"), "to": tr("Where to?")}[field]
        self.query_one("#simple-question", Static).update(tr("{question}  (Esc: back)", question=question))
        self.show()
        self.screen.set_focus(self._typed)

    @on(Input.Changed, "#simple-typed")
    def _filter(self, event: Input.Changed) -> None:
        event.stop()
        if self._choosing:
            self._fill()

    def _choices(self) -> Sequence[Place | str]:
        """Return what fits the typed text."""
        robot, typed = self._robot(), self._typed.value.strip()
        if self._choosing == "robot":
            return [name for name in self._store.state.robots if typed.casefold() in name.casefold()]
        takes_it = self._choosing == "to" or ORDER in robot.kind.accepts
        may_be_here = self._choosing == "from" and starts_here(robot)
        here = [HERE] if may_be_here and HERE.name.startswith(typed.casefold()) else []
        return [*here, *(matches(robot, typed) if takes_it else [])]

    def _fill(self) -> None:
        found = self._choices()
        self._list.show(found, [_line(choice) for choice in found])

    def _renew(self) -> bool:
        found = self._choices()
        return self._list.renew(found, [_line(choice) for choice in found])

    @on(Matches.OptionSelected, "#simple-list")
    def _clicked(self, event: Matches.OptionSelected) -> None:
        event.stop()
        self._take()

    @on(Matches.DoubleClicked)
    def _double_clicked(self, event: Matches.DoubleClicked) -> None:
        event.stop()  # the first click has chosen; only the button sends

    def _take(self) -> None:
        """Take the marked choice, and go on to the next missing one."""
        self.show()  # what has changed meanwhile is marked no more
        field, choice = self._choosing, self._list.marked
        if not field or choice is None:
            return
        self._choosing = ""
        self._say(EMPTY)
        if isinstance(choice, str):
            self._navigation.select(choice)
        else:
            self._chosen[field] = choice
        self.show()
        self._go_on()

    def _finish(self, _field: str) -> None:
        self.show()
        robot, missing = self._robot(), self._missing()
        if missing:
            self._say(
                Message(
                    "{field} is missing: choose where {purpose}",
                    field=tr(missing.capitalize()),
                    purpose=translate(_PURPOSE[missing]),
                )
            )
            self.screen.set_focus(self._button(missing))
            return
        start = self._chosen.get("from", HERE)
        self._say(self._give(order_of(robot, [start, self._chosen["to"]]), self._sent))

    def _sent(self) -> None:
        self.start()


def _line(choice: Place | str) -> str:
    if isinstance(choice, str):
        return sanitize(choice)
    return sanitize(choice.name) if choice == HERE else f"{sanitize(choice.name)}  ({sanitize(choice.floor)})"


class SimpleSwitch:
    """Creates the simple interface on first use."""

    def __init__(
        self, console: Console, panes: Panes, map_view: Widget, may_order: Callable[[], bool]
    ) -> None:
        self._console = console
        self._panes = panes
        self._map = map_view
        self._may_order = may_order
        self._simple: Simple | None = None
        self._parts = 0

    async def turn(self) -> None:
        """Show or hide the simple interface."""
        panes = self._panes
        if not panes.has_class("-simple") and not self._may_order():
            return
        if self._simple is None:
            simple = Simple(self._console, self._leave)
            await panes.floor.mount(simple, before=0)
            self._simple = simple  # not before: ticks during the mounting would query missing widgets
            self._parts = len(simple.children)
        if panes.has_class("-simple"):
            self._leave()
        else:
            panes.add_class("-simple")
            panes.share_out()
            self._simple.start()

    def _leave(self) -> None:
        self._panes.remove_class("-simple")
        self._panes.share_out()
        self._panes.screen.set_focus(self._map)

    def show(self) -> None:
        """Show the newest state."""
        # While the console ends, its widgets go one after the other.
        if self._simple is not None and len(self._simple.children) == self._parts:
            self._simple.show()
