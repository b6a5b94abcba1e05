"""Makes PNG pictures of the console's states at four sizes, in a real terminal on a virtual screen.

Run: python docs/pictures.py FOLDER [NAME ...]

Needs Xvfb, xterm and xdotool (packages of these names). Without them it exports the application's own
picture of the start, as SVG.
"""

import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image, ImageGrab

SIZES = ((60, 15), (80, 24), (120, 40), (200, 60))
CONSOLE = str(Path(sys.executable).with_name("fleet-tui"))
DISPLAY = ":77"
TERMINAL = ["xterm", "-fa", "DejaVu Sans Mono", "-fs", "10", "-b", "0", "+sb", "-tn", "xterm-256color"]
ARRIVED, SETTLED = 12.0, 0.8
"""Seconds from the start of a demo, and from a key, until the picture."""


@dataclass(frozen=True)
class Console:
    """A console, and the keys before each of its pictures: words of xdotool, `'text` is typed."""

    demo: list[str]
    states: dict[str, list[str]]
    environment: dict[str, str] = field(default_factory=dict)
    wait: float = ARRIVED


ESC = "Escape"
CONSOLES = {
    "start": Console(["--robots", "12"], {"first": []}, wait=1.2),
    "fleet": Console(
        ["--robots", "12"],
        {
            "calm": [],
            "chosen": ["4"],
            "order": ["o", "'Ba"],
            "ordered": ["Return", "'St", "Return"],
            "zoomed": ["plus", "plus", "plus", "plus", "plus", "plus"],
            "edges": ["0", "e"],
            "menu": [ESC, "Tab", "Return"],
            "why": [ESC, "w"],
            "palette": [ESC, "colon", "'pause"],
            "help": [ESC, "question"],
            "legend": [ESC, ESC, "question", "'legend"],
            "diagnostics": [ESC, ESC, ESC, "d"],
            "audit": [ESC, ESC, "'L"],
            "simple": [ESC, ESC, "s"],
            "simple-order": ["o"],
        },
    ),
    "trouble": Console(
        ["--robots", "30", "--fault", "stuck:robot_22,obstacle:robot_9"],
        {"seen": [], "alarms": ["Tab", "Tab"], "alarm-menu": ["Return"], "paused": [ESC, "'P", "'y"]},
        wait=50,
    ),
    "light": Console(["--robots", "12"], {"half-block": ["t", "t"], "light": ["'T"]}),
    "colourless": Console(["--robots", "12"], {"calm": []}, environment={"NO_COLOR": "1"}),
    "ascii": Console(["--robots", "12", "--drawing", "ascii"], {"calm": []}),
    "nav2": Console(
        ["--robots", "3", "--kind", "nav2", "--fault", "foreign-goal:robot_1"],
        {"calm": [], "order": ["o", "'Ba"]},
    ),
}


def run(*command: str) -> str:
    """Run a tool on the virtual screen and return its output."""
    return subprocess.run(
        command, env={"DISPLAY": DISPLAY, "PATH": "/usr/bin:/bin"}, capture_output=True, text=True, check=True
    ).stdout


@contextmanager
def screen() -> Iterator[None]:
    """Run a virtual screen."""
    server = subprocess.Popen(["Xvfb", DISPLAY, "-screen", "0", "2000x1400x24"], stderr=subprocess.DEVNULL)
    try:
        for _ in range(50):
            time.sleep(0.1)
            if not subprocess.run(
                ["xdotool", "getdisplaygeometry"],
                env={"DISPLAY": DISPLAY},
                check=False,
                capture_output=True,
                executable=shutil.which("xdotool"),
            ).returncode:
                break
        yield
    finally:
        server.terminate()
        server.wait()


@contextmanager
def terminal(console: Console, size: tuple[int, int]) -> Iterator[None]:
    """Run a console in a terminal of this size, in the corner of the screen."""
    with TemporaryDirectory() as home:
        environment = {
            "DISPLAY": DISPLAY,
            "HOME": home,
            "XDG_STATE_HOME": home,
            "XDG_CONFIG_HOME": home,
            "PATH": "/usr/bin:/bin",
            "LANG": "C.UTF-8",
        }
        geometry = f"{size[0]}x{size[1]}+0+0"
        # xterm drops COLORTERM from its own environment.
        variables = [f"{name}={value}" for name, value in console.environment.items()]
        program = ["env", "COLORTERM=truecolor", *variables, CONSOLE, "demo", *console.demo]
        command = [*TERMINAL, "-geometry", geometry, "-e", *program]
        process = subprocess.Popen(command, env=environment)
        try:
            yield
        finally:
            process.terminate()
            process.wait()


def window() -> str:
    """Return the number of the terminal's window."""
    return run("xdotool", "search", "--class", "xterm").split()[0]


def press(keys: list[str]) -> None:
    """Press keys, one at a time."""
    run("xdotool", "windowfocus", "--sync", window())
    for key in keys:
        if key.startswith("'"):
            run("xdotool", "type", "--delay", "60", key[1:])
        else:
            run("xdotool", "key", key)
        time.sleep(0.15)


def photograph() -> Image.Image:
    """Return the terminal's picture."""
    facts = run("xdotool", "getwindowgeometry", "--shell", window()).split()
    width, height = (int(fact.split("=")[1]) for fact in facts[3:5])
    return ImageGrab.grab((0, 0, width, height), xdisplay=DISPLAY)


def take(folder: Path, name: str, console: Console) -> None:
    """Make the pictures of one console at all sizes."""
    for width, height in SIZES:
        with terminal(console, (width, height)):
            time.sleep(console.wait)
            for state, keys in console.states.items():
                press(keys)
                time.sleep(SETTLED if keys else 0)
                path = folder / f"{name}-{state}-{width}x{height}.png"
                photograph().save(path)
                print(path)


def main(folder: Path, names: list[str]) -> None:
    """Make the pictures of the named consoles, or of all."""
    folder.mkdir(parents=True, exist_ok=True)
    with screen():
        for name in names or CONSOLES:
            take(folder, name, CONSOLES[name])


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
