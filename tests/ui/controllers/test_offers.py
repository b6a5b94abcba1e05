"""Lines of the palette: actions, a place for everything with a name, and what typed text means."""

from typing import cast

from fleet_tui.keys import Key, Pane
from fleet_tui.model.problem import Permissions, Right
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.offers import Offers
from fleet_tui.ui.controllers.save import SaveCommand
from fleet_tui.ui.controllers.session import ConsoleSession
from fleet_tui.ui.controllers.typed import Typed
from tests.support.desk import Desk, ready
from tests.support.fleets import labels, reduced


class Answers:
    """A session, or a file to save to, of which a test says what it makes of a line."""

    panes = (Pane.CONSOLE,)

    def __init__(self, prefix: str) -> None:
        self._prefix = prefix

    def offers(self, key: Key) -> bool:
        return key.pane in self.panes

    def typed(self, line: str) -> Typed | None:
        return (
            Typed(problem=Message("a {prefix}", prefix=self._prefix))
            if line.startswith(self._prefix)
            else None
        )


class Palette:
    """The offers of a desk, and which keys were run."""

    def __init__(self, right: Right = Right.SETUP) -> None:
        state = reduced(ready(), labels({1: "Base", 2: "St\x1bore", 9: "Nowhere"}))
        self.desk = Desk(state, Permissions(right=right))
        self.run: list[str] = []
        self.themes: list[str] = []
        self.offers = Offers(
            self.desk.console(themes={"dark": lambda: self.themes.append("dark")}),
            cast("ConsoleSession", Answers("time")),
            cast("SaveCommand", Answers("save")),
            self._run,
        )

    def _run(self, key: Key) -> None:
        self.run.append(key.id)

    def choose(self, text: str) -> None:
        next(offer.do for offer in self.offers.entries() if offer.text.startswith(text))()


def test_everything_with_a_name_can_be_gone_to() -> None:
    palette = Palette()
    texts = [offer.text for offer in palette.offers.entries()]
    assert {"Go to robot robot_0", "Go to floor floor_0", "Go to vertex Base", "Theme: dark"} <= set(texts)
    assert "Go to vertex St␛ore" in texts and not any("Nowhere" in text for text in texts)
    palette.choose("Go to vertex Base")
    assert palette.desk.camera.centred == [(0.0, 0.0)]
    palette.choose("Theme: dark")
    assert palette.themes == ["dark"]


def test_actions_are_those_of_the_table_that_work_here() -> None:
    palette = Palette()
    texts = [offer.text for offer in palette.offers.entries()]
    assert not any("Play or pause" in text for text in texts), "there is no recording"
    keys = {offer.text: offer.key for offer in palette.offers.entries()}
    assert keys["Pause the selected robot immediately"] == "p" and keys["Next robot"] == "."
    palette.choose("Pause the selected robot")
    assert palette.run == ["pause"]


def test_all_robots_can_be_resumed() -> None:
    palette = Palette()
    palette.choose("Resume all paused robots")
    assert palette.run == ["resume_all"]


def test_a_line_is_a_time_or_a_file_and_else_a_command() -> None:
    palette = Palette()
    assert [palette.offers.typed(line).problem for line in ("time 1", "save x")] == ["a time", "a save"]
    ((text, do), *_) = palette.offers.typed("pause robot_0").entries
    do()
    assert "robot_0" in text and len(palette.desk.backend.submitted) == 1


def test_who_may_only_view_is_offered_no_commands_and_can_type_none() -> None:
    palette = Palette(Right.VIEW)
    names = " ".join(offer.text for offer in palette.offers.entries())
    assert "Go to robot robot_0" in names
    for word in ("Pause", "Resume", "order form", "Clear all", "Cancel the order", "Arm"):
        assert word not in names, word
    typed = palette.offers.typed("pause robot_0")
    assert (typed.problem, list(typed.entries)) == ("not allowed: dispatch", [])
