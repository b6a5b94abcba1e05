"""Everything that a key of the console can do, as types: the type checker names an action that is missing."""

from collections.abc import Callable
from typing import Protocol

from msgspec import Struct

Act = Callable[[], object]
Step = Callable[[int], object]


class MapActions(Struct, frozen=True):
    """Actions of the map that work from every pane."""

    zoom_in: Act
    zoom_out: Act
    fit: Act
    zoom_about: Act
    follow: Act
    centre: Act
    edges: Act
    labels: Act
    trails: Act
    drawing: Act
    cursor: Act
    next_vertex: Step


class PlayerActions(Protocol):
    """Actions of the player of a recording."""

    def toggle(self) -> None:
        """Play, or stop."""

    def skip(self, seconds: float) -> None:
        """Go on or back by seconds."""

    def to_mark(self, step: int) -> str:
        """Go to the next (1) or previous (-1) mark. Returns why it did nothing."""

    def step(self, ticks: int) -> None:
        """Go one tick on (1) or back (-1), and stop there."""

    def step_record(self, records: int) -> None:
        """Go one record on (1) or back (-1), and stop there."""

    def change_speed(self, step: int) -> None:
        """Play faster (1), slower (-1) or as it was (0)."""

    def to_end(self, step: int) -> None:
        """Go to the beginning (-1) or the end (1)."""


Play = Callable[[Callable[[PlayerActions], object]], object]
"""Has a player do something, and shows the text that it returns."""


class AppActions(Struct, frozen=True):
    """Actions of the program and of the focus."""

    suspend: Act
    repaint: Act
    quit: Act
    back: Act
    next_pane: Act
    previous_pane: Act


class CommandActions(Struct, frozen=True):
    """Actions from which commands come, or that let them leave."""

    order: Act
    cancel: Act
    clear: Act
    pause: Act
    resume: Act
    pause_all: Act
    arm: Act


class ViewActions(Struct, frozen=True):
    """Actions that show something else."""

    help: Act
    palette: Act
    simple: Act
    why: Act
    all_orders: Act
    diagnostics: Act
    audit: Act
    go_to_time: Act
    step_robot: Step
    choose_robot: Step
    step_floor: Step


class AlarmActions(Struct, frozen=True):
    """Actions on alarms."""

    acknowledge: Act
    acknowledge_all: Act


class FileActions(Struct, frozen=True):
    """Actions that write files."""

    record: Act
    bundle: Act
    save: Act


class Actions(Struct, frozen=True):
    """All of them: bound methods of the controllers, the overlays and the app."""

    app: AppActions
    commands: CommandActions
    view: ViewActions
    alarms: AlarmActions
    files: FileActions
    map: MapActions
    play: Play
