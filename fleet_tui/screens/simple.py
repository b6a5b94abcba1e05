"""The simple interface, above the map, beside it or in its place: large buttons, for arrows or the mouse."""

from collections.abc import Callable
from typing import Any, ClassVar, Self

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widgets import Button, OptionList, Static

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.rules.language.lookup import Place, destination_only, may_skip_start, order_of, places
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.tables.doing import told_text


class Large(Button):
    """A button that acts at once: the next key goes to the result."""

    def __init__(self, label: str, field: str, pressed: Callable[[str], None], **options: Any) -> None:
        super().__init__(label, id=f"simple-{field}", **options)
        self._pressed, self._field = pressed, field

    def press(self) -> Self:
        """Press, by Enter or by mouse."""
        if self.display:
            self._pressed(self._field)
        return self


class Choices(OptionList):
    """A list whose choice acts at once."""

    def __init__(self, chosen: Callable[[int], None]) -> None:
        super().__init__(id="simple-list", markup=False)
        self._chosen = chosen

    def action_select(self) -> None:
        """Choose, by Enter or by mouse."""
        if self.highlighted is not None:
            self._chosen(self.highlighted)


class Simple(Vertical):
    """One large button for each choice; a press replaces the buttons by the list of choices. The robot is the
    console's `selected` one; `select` selects another, `close` returns to the map."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("down,j", "step(1)", "Down"),
        ("up,k", "step(-1)", "Up"),
        ("right", "step(1)", "Right"),
        ("left", "step(-1)", "Left"),
        ("escape", "back", "Back"),
    ]

    def __init__(
        self,
        state: Callable[[], FleetState],
        selected: Callable[[], str],
        select: Callable[[str], None],
        give: Callable[[Request, Callable[[], None]], str],
        close: Callable[[], None],
    ) -> None:
        super().__init__(id="simple")
        self._close = close
        self._state, self._selected, self._select, self._give = state, selected, select, give
        self._chosen: dict[str, Place] = {}
        self._whose = ""
        self._choosing = ""
        self._choices: list[Place] = []
        self._shown: tuple[object, ...] = ()

    def compose(self) -> ComposeResult:
        """Compose the four buttons, a note on missing input, and the list that replaces them."""
        for field in ("robot", "from", "to"):
            yield Large("", field, self._ask)
        yield Large(tr("Send"), "send", self._finish, variant="primary")
        yield Static(id="simple-missing", markup=False)
        yield Static(id="simple-question", markup=False)
        yield Choices(self._choose)

    def show(self) -> None:
        """Update the form when another robot is selected or its cargo changes."""
        robot = self._robot()
        if robot.name != self._whose:
            self._whose = robot.name
            self._chosen.clear()
            self._leave()
        only_to = destination_only(robot)
        to = tr("To, for the cargo on board: ") if only_to and robot.has_cargo else tr("To: ")
        start = tr("current position") if may_skip_start(robot) else tr("choose ...")
        does = told_text(self._state(), robot)
        shown = (robot.name, does, only_to, self._choosing, *self._chosen.items())
        if shown == self._shown:
            return
        self._shown = shown
        names = {field: sanitize(place.name) for field, place in self._chosen.items()}
        # As Content: a label from the wire is text, whatever markup it looks like.
        self._button("robot").label = Content(f"{tr(f'Robot: {sanitize(robot.name)}')}, {does}")
        self._button("from").label = Content(tr(f"From: {names.get('from', start)}"))
        self._button("to").label = Content(to + names.get("to", tr("choose ...")))
        self._button("send").variant = "default" if self._missing() else "primary"
        for field in ("robot", "from", "to", "send"):
            self._button(field).display = not self._choosing and (field != "from" or not only_to)
        self.set_class(not self._choosing, "-buttons")
        self.query_one("#simple-missing").display = not self._choosing
        self.query_one("#simple-question").display = self.query_one(OptionList).display = bool(self._choosing)

    def start(self) -> None:
        """Show it, with the focus on the first choice to make."""
        self._leave()
        self._say("")
        self.show()
        self._go_on()

    def _button(self, field: str) -> Button:
        return self.query_one(f"#simple-{field}", Button)

    def _robot(self) -> Robot:
        return self._state().robots[self._selected()]

    def _say(self, text: str) -> None:
        note = self.query_one("#simple-missing", Static)
        note.set_class(bool(text), "-missing")
        note.update(tr(text) or tr("Esc: back to the map"))

    def _leave(self) -> None:
        self._choosing = ""

    def _missing(self) -> str:
        """Return the first field without a choice, empty if all have one."""
        robot = self._robot()
        fields = ("to",) if destination_only(robot) or may_skip_start(robot) else ("from", "to")
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
            self._close()
            return
        self._leave()
        self.show()
        self.screen.set_focus(self._button(field))

    def _ask(self, field: str) -> None:
        """Show the list of choices."""
        robot = self._robot()
        self._choices = [] if field == "robot" else places(robot)
        names = [f"{sanitize(place.name)}  ({place.floor})" for place in self._choices]
        if field != "robot" and not names:
            self._say(tr(f"no places of {robot.name} received yet"))
            return
        self._choosing = field
        options = self.query_one(OptionList)
        options.clear_options()
        options.add_options(list(self._state().robots) if field == "robot" else names)
        options.highlighted = 0
        question = {"robot": tr("Which robot?"), "from": tr("From where?"), "to": tr("Where to?")}[field]
        self.query_one("#simple-question", Static).update(tr(f"{question}  (Esc: back)"))
        self.show()
        self.screen.set_focus(options)

    def _choose(self, index: int) -> None:
        """Take a choice, and go on to the next missing one."""
        field = self._choosing
        if not field:
            return
        self._leave()
        self._say("")
        if field == "robot":
            self._select(list(self._state().robots)[index])
        else:
            self._chosen[field] = self._choices[index]
        self.show()
        self._go_on()

    def _finish(self, _field: str) -> None:
        robot, missing = self._robot(), self._missing()
        if missing:
            self._say(tr(f"{tr(missing.capitalize())} is missing: choose where {tr(_PURPOSE[missing])}"))
            self.screen.set_focus(self._button(missing))
            return
        only_to = destination_only(robot) or (may_skip_start(robot) and "from" not in self._chosen)
        visited = [self._chosen[field] for field in (("to",) if only_to else ("from", "to"))]
        self._say(self._give(order_of(robot, visited, only_to), self._sent))

    def _sent(self) -> None:
        self._chosen.clear()
        self.start()


_PURPOSE = {"from": "the cargo is fetched", "to": "it is brought"}
