"""Real keys through a pseudo-terminal, and what reached the wire: no command that nobody meant."""

import os
import signal
import time
from collections.abc import Iterator
from functools import partial
from itertools import product

import pytest

from fleet_tui.simulator.oh_ressources.messages import graph_of, labels_of
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.terminal.typing import GAP, STANDSTILL
from tests.support.bridge_thread import BridgeThread
from tests.support.cli import config_file
from tests.support.terminal_session import InTerminal, in_terminal

DOWN, F12 = "\x1b[B", "\x1b[24~"
YES, SEND = "y  Yes", "Enter  send"

pytestmark = pytest.mark.one_fork


class Desk:
    """A console in a terminal, in front of a bridge."""

    def __init__(self, bridge: BridgeThread, terminal: InTerminal) -> None:
        self.bridge, self.terminal = bridge, terminal

    def type(self, keys: str) -> None:
        """Type in one packet, later than what was typed before: a person pauses."""
        time.sleep(GAP + 0.1)
        self.terminal.press(keys)

    def shows(self, text: str) -> None:
        self.terminal.shows(text)

    def hides(self, text: str) -> None:
        self.terminal.until(lambda: text not in self.terminal.text(), what=f"no {text}")

    def gets(self, *calls: str) -> None:
        """Wait for these calls; a key that does nothing more has been dealt with by then."""
        self.terminal.until(lambda: len(self.bridge.calls()) >= len(calls), what=str(calls))
        self.is_idle()
        assert self.bridge.calls() == list(calls)

    def is_idle(self) -> None:
        """Every key before this one has been dealt with, and whatever is open is closed."""
        for _ in range(3):
            self.terminal.press("\x1b")
            time.sleep(0.1)  # an Esc that is followed by a key at once would be read as Alt
        self.terminal.press(":zzz")
        self.shows("no match for zzz")
        self.terminal.press("\x1b")
        self.hides("no match for zzz")

    def click(self, text: str, times: int = 1) -> None:
        """Click on the last place where a text is shown."""
        rows = self.terminal.text().splitlines()
        row = max(y for y, line in enumerate(rows) if text in line)
        at = f"{rows[row].index(text) + 2};{row + 1}"
        self.terminal.press(f"\x1b[<0;{at}M\x1b[<0;{at}m" * times)


@pytest.fixture(scope="module")
def desk_of_all(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    home = tmp_path_factory.mktemp("home")
    bridge = BridgeThread()
    try:
        config = config_file(home, bridge.server.url, 2, 2)
        with in_terminal(home, "--config", str(config)) as terminal:
            terminal.shows("robot_1")
            terminal.shows("Packing")
            yield Desk(bridge, terminal)
    finally:
        bridge.close()


@pytest.fixture
def desk(desk_of_all: Desk) -> Desk:
    """The console with robot_0 selected, nothing open, and robots at rest."""
    desk_of_all.bridge.rest()
    desk_of_all.is_idle()
    desk_of_all.type(":robot_0\r")
    desk_of_all.is_idle()
    for text in ("Cargo     no ", "Paused    no ", "no orders: press o"):
        desk_of_all.shows(text)
    desk_of_all.bridge.forget()
    return desk_of_all


def plant(robot: SimRobot, cargo: bool, paused: bool, order: tuple[int, int] | None, _server: object) -> None:
    robot.drop({one.id for one in robot.orders})
    if order is not None:
        robot.take(*order, 0)
    robot.cargo, robot.paused = cargo, paused


@pytest.mark.nightly
def test_the_tutorials_keys_place_one_order_or_open_one_question_in_every_state(desk: Desk) -> None:
    robot, base, packing = desk.bridge.robot(), desk.bridge.id_of("Base"), desk.bridge.id_of("Packing")
    order = f"robot_0 Execute_order {base} {packing}"
    for cargo, has_order, paused in product((False, True), repeat=3):
        desk.bridge.do(partial(plant, robot, cargo, paused, (packing, base) if has_order else None))
        desk.shows(f"Cargo     {'yes' if cargo else 'no '}")
        desk.shows(f"Paused    {'yes' if paused else 'no '}")
        desk.shows("Packing -> Base" if has_order else "no orders: press o")
        desk.bridge.forget()
        desk.type("oBase\rPacking\r")
        asks = paused or (cargo and not has_order)
        if asks:
            desk.shows(YES)
            desk.is_idle()
            assert desk.bridge.calls() == []
        else:
            desk.gets(order)
        desk.bridge.rest()


def test_what_is_typed_on_after_a_form_does_nothing_and_f12_pauses(desk: Desk) -> None:
    base, packing = desk.bridge.id_of("Base"), desk.bridge.id_of("Packing")
    desk.type("oBase\rPacking\rPxyXr\r")
    desk.shows("6 keys dropped, typed on after Enter")
    desk.gets(f"robot_0 Execute_order {base} {packing}")
    desk.bridge.rest()
    desk.type("oBase\rPacking\rP" + F12)
    desk.gets(f"robot_0 Execute_order {base} {packing}", "robot_0 Pause", "robot_1 Pause")


def test_letters_in_lists_are_text(desk: Desk) -> None:
    desk.type("s")
    desk.shows("From: choose")
    for word in ("Pack", "Sto"):
        desk.type("\r")
        desk.shows("From where?")
        desk.type(word)
        desk.shows({"Pack": "Packing  (floor_0)", "Sto": "Store  (floor_0)"}[word])
        desk.terminal.press("\x1b")
        desk.shows("From: choose")
    desk.terminal.press("\x1b")
    desk.is_idle()
    assert desk.bridge.calls() == []


@pytest.mark.nightly
def test_what_was_chosen_and_left_is_gone(desk: Desk) -> None:
    for word, field in (("Base", "From: Base"), ("Packing", "To: Packing")):
        desk.type("s\r" if word == "Base" else "\r")
        desk.shows("(Esc: back)")
        desk.type(f"{word}\r")
        desk.shows(field)
    desk.terminal.press("\x1b")
    desk.hides("To: Packing")
    desk.type("s")
    desk.shows("To: choose")
    desk.type("\r")
    desk.shows("From where?")
    desk.is_idle()
    assert desk.bridge.calls() == []


@pytest.mark.nightly
def test_a_place_that_an_order_cannot_name_is_refused_before_it_is_sent(desk: Desk) -> None:
    """Floors that share labels and ids: the wire has only the id, and the robot is on floor_0."""
    first, second = desk.bridge.server.world.building.floors
    names = {floor: f"/robot_0/{floor.name}" for floor in (first, second)}
    desk.bridge.publish(f"{names[second]}/graph", graph_of(first))
    desk.bridge.publish(f"{names[second]}/labeled_vertices", labels_of(first))
    try:
        desk.type("oBase\rPacking")
        desk.shows("floor_1")
        desk.terminal.press(DOWN)
        desk.shows("can't be ordered: where robot_0 is, the id")
        desk.type("\r")
        desk.is_idle()
        assert desk.bridge.calls() == []
    finally:
        desk.bridge.publish(f"{names[second]}/graph", graph_of(second))
        desk.bridge.publish(f"{names[second]}/labeled_vertices", labels_of(second))


@pytest.mark.nightly
def test_a_form_works_on_one_picture_of_the_labels(desk: Desk) -> None:
    floor = desk.bridge.server.world.building.floors[0]
    swapped = {"Base": "Packing", "Packing": "Base"}
    message = labels_of(floor)
    other = {
        **message,
        "vertices": [
            {**one, "label": swapped.get(one["label"], one["label"])} for one in message["vertices"]
        ],
    }
    try:
        desk.type("oBase\rStore")
        desk.shows(SEND)
        desk.bridge.publish(f"/robot_0/{floor.name}/labeled_vertices", other)
        desk.shows("Base: changed meanwhile, choose again")
        desk.type("\r")
        desk.shows("Enter  next")
        desk.shows("Base: changed meanwhile, choose again")
        desk.is_idle()
        assert desk.bridge.calls() == []
    finally:
        desk.bridge.publish(f"/robot_0/{floor.name}/labeled_vertices", message)


def test_a_click_chooses_and_the_button_sends(desk: Desk) -> None:
    base, packing = desk.bridge.id_of("Base"), desk.bridge.id_of("Packing")
    desk.type("oBase\rPack")
    desk.terminal.until(lambda: desk.terminal.text().count(" m from Base") == 1, what="one match")
    desk.click(" m from Base")
    desk.terminal.until(lambda: "To      Packing" in desk.terminal.text(), what="To Packing")
    assert desk.bridge.calls() == []
    desk.click(SEND)
    desk.gets(f"robot_0 Execute_order {base} {packing}")


@pytest.mark.nightly
def test_a_question_is_about_the_order_that_was_asked_about(desk: Desk) -> None:
    robot, base, packing = desk.bridge.robot(), desk.bridge.id_of("Base"), desk.bridge.id_of("Packing")

    def restarted(server: RosbridgeServer) -> None:
        robot.drop({one.id for one in robot.orders})
        robot.last_order_id = 0
        robot.take(packing, base, 0)

    desk.bridge.do(lambda server: setattr(robot, "last_order_id", 0))
    desk.bridge.do(lambda server: robot.take(base, packing, 0))
    desk.shows("Base -> Packing")
    desk.type("x")
    desk.shows("Cancel order 1 of robot_0?")
    desk.bridge.do(restarted)
    desk.shows("not sent: order 1 of robot_0 is a different one now")
    desk.type("y")
    desk.is_idle()
    assert desk.bridge.calls() == []


@pytest.mark.nightly
def test_all_are_paused_from_menus_and_questions_and_ctrl_c_names_the_key_that_quits(desk: Desk) -> None:
    desk.bridge.do(
        lambda server: desk.bridge.robot().take(desk.bridge.id_of("Base"), desk.bridge.id_of("Store"), 0)
    )
    desk.shows("Base -> Store")
    for opens, text in (("\r", "1  Order"), ("X", YES), ("w", "Why: robot_0")):
        desk.type(opens)
        desk.shows(text)
        desk.type("P")
        desk.gets("robot_0 Pause", "robot_1 Pause")
        desk.bridge.forget()
    for key in ("\x03", "\x11"):
        desk.type(key)
        desk.shows("q quits")
        desk.is_idle()
    desk.shows(" q quit ")
    assert desk.bridge.calls() == []


@pytest.mark.nightly
def test_keys_belong_to_what_is_shown(desk: Desk) -> None:
    desk.type("\tg")
    desk.shows(" cell ")
    desk.type(DOWN)  # moves the cursor of the map, and not that of the fleet, which selects
    desk.type("p")
    desk.gets("robot_0 Pause")
    desk.bridge.forget()
    desk.type("1p")
    desk.gets("robot_1 Pause")
    desk.bridge.forget()
    desk.type(":pause 1\r")
    desk.gets("robot_1 Pause")


@pytest.mark.nightly
def test_a_disarmed_console_pauses_and_sends_nothing_else(desk: Desk) -> None:
    desk.type(":arm\r")
    desk.shows("not armed")
    try:
        desk.type("r")
        desk.shows("not sent: this console is not armed")
        for keys, calls in (
            ("p", ["robot_0 Pause"]),
            ("P", ["robot_0 Pause", "robot_1 Pause"]),
            (F12, ["robot_0 Pause", "robot_1 Pause"]),
        ):
            desk.type(keys)
            desk.gets(*calls)
            desk.bridge.forget()
    finally:
        desk.type(":arm\r")
        desk.shows("this console is armed")


@pytest.mark.nightly
def test_keys_that_waited_while_the_console_stood_still_are_dropped_but_a_pause_of_all(desk: Desk) -> None:
    for keys, calls in (("oBase\rPacking\rP", []), ("P", ["robot_0 Pause", "robot_1 Pause"])):
        os.kill(desk.terminal.child.pid, signal.SIGSTOP)
        try:
            desk.terminal.press(keys)
            time.sleep(STANDSTILL + 1.5)  # as long as it must stand still to be noticed
        finally:
            os.kill(desk.terminal.child.pid, signal.SIGCONT)
        if not calls:
            desk.shows("15 keys dropped, typed while nothing could be shown")
        desk.gets(*calls)
