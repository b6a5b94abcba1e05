"""Makes pictures of the console in a real terminal on a virtual screen.

Run: python docs/pictures.py states FOLDER [NAME ...]   every state at four sizes, to be looked at
     python docs/pictures.py docs [NAME ...]            the pictures in docs/; by default all; `film` moves

Needs Xvfb, xterm and xdotool, which are Debian packages of these names, and for `shift` chromium; without
them `states` writes what the application exports itself.
"""

import asyncio
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from PIL import Image, ImageGrab

from fleet_tui.config.load import load, shipped
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.console.demo import demo_config, simulated
from fleet_tui.state.store import Store
from fleet_tui.ui.backend import LiveBackend
from fleet_tui.ui.themes import load_themes
from fleet_tui.ui.view.map.drawing import Drawing

SIZES = ((60, 15), (80, 24), (120, 40), (200, 60))
CONSOLE = str(Path(sys.executable).with_name("fleet-tui"))
TERMINAL = ["xterm", "-fa", "DejaVu Sans Mono", "-fs", "10", "-b", "0", "+sb", "-tn", "xterm-256color"]
ARRIVED, SETTLED = 12.0, 0.8
"""Seconds from the start of a demo, and from a key, until the picture."""


@dataclass(frozen=True)
class Console:
    """A console, and the keys before each of its pictures: words of xdotool, `'text` is typed. `wait` and
    `settled`: seconds before the first keys, and from keys to the picture. `files`: those of a site, its
    configuration without the bridge among them; without any it is a demo, or a shell's `script` with the
    console as $0."""

    demo: list[str]
    states: dict[str, list[str]]
    environment: dict[str, str] = field(default_factory=dict)
    wait: float = ARRIVED
    settled: float = SETTLED
    files: dict[str, str] = field(default_factory=dict)
    script: str = ""


FRAME = 0.5
"""Seconds between the frames of the moving picture."""
COLOURS = 64

ESC = "Escape"
DRAW = ["E", "'iL", "Up", "'eJ", "Down", "'eHH", "'e"]
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
    "light": Console(["--robots", "12"], {"half-block": ["m"], "light": ["colon", "'theme light", "Return"]}),
    "colourless": Console(["--robots", "12"], {"calm": []}, environment={"NO_COLOR": "1"}),
    "ascii": Console(["--robots", "12", "--drawing", "ascii"], {"calm": []}),
    "nav2": Console(
        ["--robots", "3", "--kind", "nav2", "--fault", "foreign-goal:robot_1"],
        {"calm": [], "order": ["o", "'Ba"], "pose": [ESC, ESC, "'IL", "Right", "Up", "'hh"]},
    ),
    "edit": Console(["--robots", "3"], {"drawn": DRAW, "checks": ["exclam"], "menu": [ESC, "Return"]}),
}

NAV2_ALONE = ["--robots", "1", "--floors", "1", "--kind", "nav2"]
ORDER = ["o", "'Ba", "Return", "'Con", "Return"]
SITE = """
[[floors]]
name = "floor_0"
[[robots]]
name = "robot_0"
[[robots]]
name = "robot_1"
[[programs]]
name = "bridge"
start = ["true"]
stop = ["true"]
status = ["true"]
[[programs]]
name = "mapping"
start = ["sh", "-c", "echo waits for the laser; sleep 2; echo no laser: /dev/ttyUSB0 is not there; exit 3"]
needs = ["bridge"]
"""
MORNING = """every weekday 06:30
for robot_0 robot_1
  repeat 2
    go Base
    carry Base Consumidores
    wait 30 s
  end
  on failure
    go Base
  end
end
"""
DOCS = {
    "console": ((120, 32), Console(["--robots", "12"], {"ordered": ORDER, "edges": ["e"]})),
    "small": ((80, 24), Console(["--robots", "12"], {"form": ["o", "'Rec", "Return", "'Con"]})),
    "light": (
        (120, 32),
        Console(
            ["--robots", "12"],
            {"theme": ["colon", "'theme light", "Return"], "trails": ["t"], "paused": ["'P"]},
        ),
    ),
    "editing": ((100, 28), Console(["--robots", "3"], {"drawn": DRAW}, wait=8)),
    "nav2": (
        (100, 34),
        Console(
            ["--robots", "3", "--floors", "1", "--kind", "nav2", "--fault", "foreign-goal:robot_1"],
            {"orders": ["colon", "'robot_0 Base > Consumidores", "Return"]},
            wait=25,
        ),
    ),
    "pose": (
        (100, 30),
        Console(
            [*NAV2_ALONE, "--fault", "mislocalised"],
            {"laser": ["'u"], "mode": ["'I"], "moved": ["Up", "Right", "'s", "plus"]},
        ),
    ),
    "mapping": (
        (100, 30),
        Console(
            [*NAV2_ALONE, "--speed", "4"],
            {
                # What follows typed text at once is dropped.
                "mapping": ["colon", "'mapping robot_0 on", "Return"],
                "on": ["'y"],
                "driving": ["colon", "'robot_0 Base > Consumidores", "Return"],
                "driven": ["'y"],
            },
            settled=6,
        ),
    ),
    "camera": ((100, 30), Console(NAV2_ALONE, {"open": ["V"]}, settled=5)),
    "driving": (
        (100, 30),
        Console(
            NAV2_ALONE,
            # The last picture is made while the key still counts as held.
            {"asked": ["T"], "begun": ["'y"], "nearer": ["plus"] * 12, "back": ["'" + "s" * 20]},
            settled=0,
        ),
    ),
    "programs": (
        (100, 16),
        Console(
            [],
            {"list": ["J"], "menu": ["Down", "Return"], "asked": ["1"], "failed": ["y"]},
            settled=5,
            files={"config.toml": SITE},
        ),
    ),
    "routines": (
        (100, 16),
        Console(
            [],
            {"list": ["B"], "menu": ["Return"], "asked": ["1"], "led": ["y"]},
            settled=5,
            files={"config.toml": SITE, "routines/morning.routine": MORNING},
        ),
    ),
}
"""The pictures of the documentation, by name: size, console, and the keys before them."""


MOVING, SHIFT = "film", "shift"
"""The names of the moving picture, and of those of the history and its report."""
LASTS = 420.0
"""Seconds for which the history is collected that they show."""


class Take(NamedTuple):
    """Keys of the moving picture, then seconds that are not in it, then seconds that are."""

    keys: list[str]
    seconds: float
    unseen: float = 0


FILMED = Console(
    [],
    {},
    # With this many robots, robot_6 meets an obstacle after 33 s, for 8 s.
    wait=31.5,
    script="""
        "$0" demo --robots 7
        "$0" replay "$(ls "$XDG_STATE_HOME"/fleet-tui/recent/demo/*.gz | tail -n 1)" --at +28s
    """,
)
FILM = [
    Take(["6"], 4.5),
    Take(["w"], 2.5),
    Take([ESC, "o", "'Ba", "Return", "'Con"], 0.5),
    Take(["Return"], 2.5),
    Take(["q"], 1, unseen=9),
    Take(["6", "parenright"], 1.5),
    Take(["less", "F", "F"], 2.5),
]


@contextmanager
def screen() -> Iterator[None]:
    """Run a virtual screen, the DISPLAY of all that is started meanwhile."""
    command = ["Xvfb", "-displayfd", "1", "-screen", "0", "2000x1400x24"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        assert server.stdout is not None
        os.environ["DISPLAY"] = f":{server.stdout.readline().strip()}"
        try:
            yield
        finally:
            server.terminate()


def run(*command: str) -> str:
    """Run a tool on the virtual screen and return its output."""
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@contextmanager
def command_of(console: Console, home: Path) -> Iterator[list[str]]:
    """Write the console's files, run the bridge that they need, and yield the console's command."""
    if console.script:
        yield ["sh", "-c", console.script, CONSOLE]
        return
    if not console.files:
        yield [CONSOLE, "demo", *console.demo]
        return
    with simulated(2, 1) as (url,):
        for name, text in console.files.items():
            (home / name).parent.mkdir(exist_ok=True)
            (home / name).write_text(text)
        config = home / "config.toml"
        config.write_text(f'[rosbridge]\nurl = "{url}"\n{config.read_text()}')
        yield [CONSOLE, "--config", str(config)]


@contextmanager
def terminal(console: Console, size: tuple[int, int]) -> Iterator[None]:
    """Run a console in a terminal of this size, in the corner of the screen."""
    with TemporaryDirectory() as home, command_of(console, Path(home)) as started:
        own = {"HOME": home, "XDG_STATE_HOME": home, "XDG_CONFIG_HOME": home, "LANG": "C.UTF-8"}
        environment = {**own, "PATH": os.environ["PATH"], "DISPLAY": os.environ["DISPLAY"]}
        geometry = f"{size[0]}x{size[1]}+0+0"
        # xterm drops COLORTERM from its own environment.
        variables = [f"{name}={value}" for name, value in console.environment.items()]
        program = ["env", "COLORTERM=truecolor", *variables, *started]
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
    return ImageGrab.grab((0, 0, width, height), xdisplay=os.environ["DISPLAY"])


def states(folder: Path, names: list[str]) -> None:
    """Make the pictures of the named consoles, or of all, in each state and size."""
    for name in names or CONSOLES:
        console = CONSOLES[name]
        for width, height in SIZES:
            with terminal(console, (width, height)):
                time.sleep(console.wait)
                for state, keys in console.states.items():
                    press(keys)
                    time.sleep(console.settled if keys else 0)
                    photograph().save(folder / f"{name}-{state}-{width}x{height}.png")


def pictures_of_docs(names: list[str]) -> None:
    """Make the named pictures that documentation pages show, or all."""
    folder = Path(__file__).parent
    for name in names or [*DOCS, *WHOLE]:
        if name in WHOLE:
            WHOLE[name](folder)
            continue
        size, console = DOCS[name]
        with terminal(console, size):
            time.sleep(console.wait)
            for keys in console.states.values():
                press(keys)
                time.sleep(console.settled)
            photograph().quantize(COLOURS, dither=Image.Dither.NONE).save(
                folder / f"{name}.png", optimize=True
            )


def shift(folder: Path) -> None:
    """Make the pictures of a history that was collected, in the console and as a report."""
    faults = "obstacle:robot_4,battery:robot_9"
    with TemporaryDirectory() as home, simulated(12, 2, faults, speed=6.0) as (url,):
        config = Path(home) / "depot" / "config.toml"
        config.parent.mkdir()
        own = {"HOME": home, "XDG_STATE_HOME": home, "XDG_CONFIG_HOME": home, "LANG": "C.UTF-8"}
        environment = {"PATH": os.environ["PATH"], "DISPLAY": os.environ["DISPLAY"], **own}
        found = [CONSOLE, "config", "init", "--from-live", url, "--output", str(config)]
        subprocess.run(found, env=environment, check=True)
        collect = [CONSOLE, "history", "--collect", "--config", str(config)]
        with subprocess.Popen(collect, env=environment) as collecting:
            time.sleep(LASTS)
            collecting.terminate()
        geometry = [*TERMINAL, "-geometry", "120x26+0+0", "-e", "env", "COLORTERM=truecolor"]
        with subprocess.Popen([*geometry, CONSOLE, "--config", str(config)], env=environment) as console:
            time.sleep(ARRIVED)
            press(["colon", "'note Lift B is slow: goods for floor_1 go by the ramp", "Return"])
            time.sleep(3)
            press(["'H2"])
            time.sleep(3)
            photograph().quantize(COLOURS, dither=Image.Dither.NONE).save(
                folder / "history.png", optimize=True
            )
            console.terminate()
        page = Path(home) / "shift.html"
        subprocess.run(
            [CONSOLE, "report", "--since", "8m", "--output", str(page), "--config", str(config)],
            env=environment,
            check=True,
        )
        browse(page, folder / "report.png")


def browse(page: Path, picture: Path) -> None:
    """Make a picture of the beginning of a page in a browser."""
    with TemporaryDirectory() as profile:
        options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}"]
        size = ["--window-size=1040,1500", "--hide-scrollbars", f"--screenshot={picture}"]
        subprocess.run(["chromium", *options, *size, page.as_uri()], check=True, stderr=subprocess.DEVNULL)
    with Image.open(picture) as shot:
        shot.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(picture, optimize=True)


def film(folder: Path) -> None:
    """Make the moving picture: an obstacle, its explanation, an order, and all that once more as a replay."""
    path = folder / "console.gif"
    frames: list[Image.Image] = []
    with terminal(FILMED, (100, 30)):
        time.sleep(FILMED.wait)
        for take in FILM:
            for key in take.keys:
                press([key])
                if not take.unseen:
                    frames.append(photograph())
            time.sleep(take.unseen)
            for _ in range(int(take.seconds / FRAME)):
                time.sleep(FRAME)
                frames.append(photograph())
    width, height = frames[0].size
    all_colours = Image.new("RGB", (width, height * len(frames)))
    for number, frame in enumerate(frames):
        all_colours.paste(frame, (0, number * height))
    palette = all_colours.quantize(COLOURS, dither=Image.Dither.NONE)
    first, *more = (frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames)
    first.save(path, save_all=True, append_images=more, duration=int(FRAME * 1000), loop=0, optimize=True)


WHOLE = {SHIFT: shift, MOVING: film}
"""Pictures that are more than one console in one state."""


async def export(folder: Path) -> None:
    """Write what the application itself can draw, as SVG: the calm state at each size."""
    with simulated(12, 2) as (url,), TemporaryDirectory() as home:
        config = demo_config(load(shipped()), url, 12, 2, folder=Path(home))
        for width, height in SIZES:
            store = Store(initial_state(config, time.monotonic()))
            app = FleetApp(
                config, store, load_themes(None)[0], Drawing.BRAILLE, backend=LiveBackend(config, store)
            )
            async with app.run_test(size=(width, height)):
                await asyncio.sleep(ARRIVED)
                picture = app.export_screenshot(title="fleet-tui demo")
            (folder / f"fleet-calm-{width}x{height}.svg").write_text(picture)


def main(what: str, arguments: list[str]) -> None:
    """Make pictures of all states, or those of the documentation."""
    missing = [tool for tool in ("Xvfb", "xterm", "xdotool") if shutil.which(tool) is None]
    if missing and what == "docs":
        sys.exit(f"not installed: {', '.join(missing)} (Debian: apt install xvfb xterm xdotool)")
    if arguments and what == "states":
        Path(arguments[0]).mkdir(parents=True, exist_ok=True)
    if missing:
        sys.stderr.write(
            f"without {', '.join(missing)}: only the calm state, as the application exports it\n"
        )
        asyncio.run(export(Path(arguments[0])))
        return
    with screen():
        if what == "docs":
            pictures_of_docs(arguments)
        else:
            states(Path(arguments[0]), arguments[1:])


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
