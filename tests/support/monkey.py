"""Keys, mouse, pastes and sizes at random, at the real console: none of them ends it or fails in it.

Run: python -m tests.support.monkey --minutes 10 --seed 1
"""

import argparse
import random
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from fleet_tui.keys import KEYS
from tests.support.terminal_session import InTerminal, in_terminal

TROUBLE = "obstacle:robot_0,battery:robot_1,stuck:robot_2,jumping:robot_3,silent:robot_4,paused:robot_5"
DEMO = ("demo", "--robots", "6", "--fault", TROUBLE)
NAMED = {
    "enter": "\r",
    "escape": "\x1b",
    "tab": "\t",
    "shift+tab": "\x1b[Z",
    "up": "\x1b[A",
    "down": "\x1b[B",
    "right": "\x1b[C",
    "left": "\x1b[D",
    "home": "\x1b[H",
    "end": "\x1b[F",
    "pageup": "\x1b[5~",
    "pagedown": "\x1b[6~",
    "delete": "\x1b[3~",
    "backspace": "\x7f",
    "space": " ",
    "f1": "\x1bOP",
    "f12": "\x1b[24~",
    "ctrl+p": "\x10",
    "ctrl+l": "\x0c",
    "ctrl+a": "\x01",
    "ctrl+k": "\x0b",
    "ctrl+w": "\x17",
}
LEAVE = {"q", "ctrl+z"}
OFTEN = ["enter", "escape", "tab", "up", "down", "right", "left", ":", "d", "o", "s", "L", "?", "w", "/", "x"]
WORDS = [
    "order robot_1 Base",
    "pause all",
    "robot_",
    "@12:00",
    "cancel 1",
    "Store",
    "9" * 300,
    "é漢\u202e[b]",
]
SIZES = [(120, 40), (80, 24), (200, 60), (60, 16), (59, 15), (20, 5), (1, 1)]


def _strokes() -> list[str]:
    keys = [one for key in KEYS for one in key.keys if one not in LEAVE]
    return [NAMED.get(key, key) for key in [*keys, *OFTEN * 3, *NAMED]]


def moves(chance: random.Random) -> Iterator[str | tuple[int, int]]:
    """Bytes to type, or a size, without end."""
    strokes, (width, height) = _strokes(), SIZES[0]
    while True:
        kind = chance.random()
        if kind < 0.8:
            yield chance.choice(strokes)
        elif kind < 0.95:
            at = f"{chance.randint(1, width)};{chance.randint(1, height)}"
            button = chance.choice([0, 0, 0, 2, 35, 64, 65])
            yield f"\x1b[<{button};{at}M" + (f"\x1b[<{button};{at}m" if button < 3 else "")
        elif kind < 0.98:
            word = chance.choice(WORDS)
            yield chance.choice([word, f"\x1b[200~{word}\x1b[201~"])
        else:
            width, height = chance.choice(SIZES)
            yield width, height


def play(running: InTerminal, seconds: float, seed: int) -> int:
    """The number of moves that it took. Raises AssertionError at a fault of the console's own."""
    log = running.home / "state" / "fleet-tui" / "fleet-tui.log"
    end, done = time.monotonic() + seconds, 0
    for move in moves(random.Random(seed)):
        if time.monotonic() > end:
            break
        if isinstance(move, str):
            running.press(move)
        else:
            running.resize(*move)
        done += 1
        time.sleep(0.02)
        assert running.child.poll() is None, f"ended after {done} moves: {move!r}\n{running.text()}"
    running.resize(120, 40)
    running.forget()
    running.press("\x0c")  # paints all anew, over whatever is open
    running.until(lambda: "alarm" in running.text().splitlines()[0], what="the line that is always in view")
    assert "Traceback" not in log.read_text(), log.read_text()
    return done


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=0)
    told = parser.parse_args()
    with tempfile.TemporaryDirectory() as home, in_terminal(Path(home), *DEMO) as running:
        running.shows("robot_5")
        print(f"{play(running, told.minutes * 60, told.seed)} moves, no fault")


if __name__ == "__main__":
    main()
