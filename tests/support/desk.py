"""The controllers of a console without a screen: what they say, ask, open and send."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from fleet_tui.model.attention import SeenArea
from fleet_tui.model.commands import Command
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import CargoReported, CommandPathChanged, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.model.problem import Permissions
from fleet_tui.model.request import Request
from fleet_tui.model.set_up.driving import DrivePhase, DriveState, Steering
from fleet_tui.state.store import Store
from fleet_tui.state.streams import Streams
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console, InBackground
from fleet_tui.ui.controllers.dispatch import Dispatch
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.navigation import Navigation
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.controllers.settings import ConsoleSettings
from fleet_tui.ui.controllers.tables.marked import MarkedCommands
from fleet_tui.ui.controllers.typed import Entry
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.fleets import LINK, R0, T0, fleet, graph, labels, link_up, pose, queue, reduced, tick
from tests.support.kinds import KEYS


class StubDrive:
    """A drive without a wire: keeps what it is asked for. Its state is for tests to change."""

    def __init__(self) -> None:
        self.state = DriveState()
        self.steered: list[Steering] = []

    def steer(self, steering: Steering) -> None:
        self.steered.append(steering)

    def end(self, reason: Message) -> None:
        if self.state.phase is not DrivePhase.ENDED:
            self.state = DriveState(DrivePhase.ENDED, reason=reason)


class CollectingBackend:
    """Keeps what is submitted."""

    def __init__(self, refusal: Message = EMPTY) -> None:
        self.refusal, self.submitted, self.events = refusal, list[Command](), list[Event]()
        self.counters: Mapping[str, LinkCounter] = {}
        self.streams = Streams()
        self.drives: list[StubDrive] = []

    def watch(self, robot: str, key: str) -> None:
        self.streams.watch(robot, key)

    def unwatch(self, robot: str, key: str) -> None:
        self.streams.unwatch(robot, key)

    def open(self) -> None: ...

    def drive(self, robot: str) -> StubDrive:
        self.drives.append(StubDrive())
        return self.drives[-1]

    def submit(self, *commands: Command) -> Message:
        self.submitted += commands
        return EMPTY

    def post(self, event: Event) -> Message:
        self.events.append(event)
        return EMPTY

    def show_map(self, robot: str, floor: str) -> None: ...

    def subscribe_logs(self, on: bool) -> None: ...

    def close(self) -> None: ...


class Menu(NamedTuple):
    """A menu that was opened."""

    title: Message
    entries: Sequence[Entry]
    marked: int

    @property
    def texts(self) -> list[str]:
        return [text for text, _ in self.entries]

    def choose(self, text: str) -> None:
        """Choose the entry that begins so."""
        next(do for entry, do in self.entries if entry.startswith(text))()


class Camera:
    """Keeps where the map was brought to; None is the selected robot. `revealed` counts how often that was
    brought into view."""

    def __init__(self) -> None:
        self.centred = list[tuple[float, float] | None]()
        self.revealed = 0
        self.follows = False
        self.area: SeenArea | None = None

    def reveal(self) -> None:
        self.revealed += 1

    def stop_following(self) -> None:
        self.follows = False

    def centre(self, at: tuple[float, float] | None = None) -> None:
        self.centred.append(at)

    def seen(self) -> SeenArea | None:
        return self.area


class Desk:
    """A Dispatch, a Navigation and Notices, and all that they said, asked and opened."""

    def __init__(
        self, state: FleetState, permissions: Permissions | None = None, refusal: Message = EMPTY
    ) -> None:
        self.store, self.backend = Store(state), CollectingBackend(refusal)
        self.notices = Notices(self.store, self._hear)
        self.said: list[str] = []
        """Notices, each once."""
        self.answers: list[Callable[[], None]] = []
        self.charge: Callable[[], None] | None = None
        """What the last question offers in place of the order."""
        self.menus: list[Menu] = []
        self.selected: list[str] = []
        self.camera = Camera()
        allowed = permissions or Permissions()
        self.dispatch = Dispatch(self.store, self.backend, allowed, self.notices, self.ask)
        self.navigation = Navigation(self.store, self.selected.append, lambda: self.camera, lambda: None)
        self.begun: list[str] = []
        """Lines with which the palette was opened."""
        self.in_background: InBackground = lambda work, then: then(work())
        self.marks: list[str] = []
        self.outcomes: list[tuple[Command, str]] = []
        self.asked: list[str] = []
        self.marked = MarkedCommands(
            self.console(),
            lambda: self.marks,
            lambda told, _since: self.outcomes.extend(told),
            self.marks.clear,
        )

    def console(self, files: ConsoleFiles | None = None, **settings: Any) -> Console:
        """A console with these files and settings, on this desk; what it does in a thread is done at once."""
        chosen = {"keys": KEYS, "clock": lambda _wall: "12:00:00", "permissions": self.dispatch.permissions}
        chosen |= {"drawing": Drawing.ASCII, "themes": {}, "announce": lambda _state: None}
        return Console(
            store=self.store,
            backend=self.backend,
            dispatch=self.dispatch,
            notices=self.notices,
            navigation=self.navigation,
            files=files or ConsoleFiles(),
            settings=ConsoleSettings(**{**chosen, "resized": lambda: None, **settings}),
            ask=self.ask,
            open_menu=self.open_menu,
            begin=self.begun.append,
            in_background=lambda work, then: self.in_background(work, then),
            say_from_thread=self.notices.say,
        )

    def _hear(self) -> None:
        if self.notices.text:
            self.said.append(self.notices.text)

    def ask(
        self, question: Callable[[], str], then: Callable[[], None], charge: Callable[[], None] | None = None
    ) -> None:
        self.charge = charge
        self.asked.append(question())
        assert self.asked[-1]
        self.answers.append(then)

    def open_menu(
        self, title: Message, entries: Sequence[Entry], marked: int = 0, *, searched: bool = False
    ) -> None:
        self.menus.append(Menu(title, entries, marked))

    def do(self, command: Command) -> None:
        """Ask for it, and say yes to whatever is asked."""
        self.dispatch.do(Request((command,)))
        self.say_yes()

    def say_yes(self) -> None:
        for yes in self.answers:
            yes()


def ready() -> FleetState:
    """robot_0 online at vertex 1, with order 1."""
    known = (
        graph(1, 2),
        labels({1: "Base", 2: "Store"}),
        queue(T0, (1, 1, 2, "W")),
        CargoReported(R0, T0, False),
    )
    alive = CommandPathChanged(LINK, CommandPath.ALIVE, connected=True)
    return reduced(fleet(1), link_up(T0), alive, *known, pose(T0), tick(T0 + 0.5))
