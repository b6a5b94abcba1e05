"""Try the wheel, the sdist and the single file of dist/, each in an empty place and without network.

Run: python -m release.check, after release.build, on Linux with `unshare` and `ip`.
"""

import os
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from fleet_tui import __version__
from release.build import DIST, PYTHON
from release.locked import ROOT, constraints
from tests.support.in_pty import Terminal

PIP = ["-m", "pip", "--quiet", "--disable-pip-version-check"]
INSIDE = "inside"
"""The argument of the process without network."""

WAYS = {"wheel": "*.whl", "sdist": "*.tar.gz", "single file": f"*-py{PYTHON.replace('.', '')}-*.pyz"}
LIGHT = '[[floors]]\nname = "floor_0"\n[[robots]]\nname = "robot_0"\n[ui]\ntheme = "light"\n'


def built(pattern: str) -> Path:
    """Return the built file of this version."""
    (found,) = (path for path in DIST.glob(pattern) if f"-{__version__}" in path.name)
    return found


def collect(wheels: Path) -> None:
    """Download what wheel and sdist need, the last step with a network."""
    tested = constraints(wheels / "versions.txt")
    needed = [f"{built('*.whl')}[serve,bags]", "hatchling"]
    subprocess.run([sys.executable, *PIP, "download", "--dest", str(wheels), *tested, *needed], check=True)


def program(way: str, place: Path, wheels: Path) -> list[str]:
    """Install one of the three into an empty place, and return the command that starts it."""
    file = built(WAYS[way])
    if way == "single file":
        return [sys.executable, str(file)]
    python = place / "venv" / "bin" / "python"
    subprocess.run([sys.executable, "-m", "venv", str(place / "venv")], check=True)
    source = ["--no-index", "--find-links", str(wheels)]
    subprocess.run([python, *PIP, "install", *source, f"{file}[serve,bags]"], check=True)
    return [str(python.with_name("fleet-tui"))]


class Trial:
    """One installed program, in its own empty home."""

    def __init__(self, command: Sequence[str], home: Path) -> None:
        self._command, self._home = list(command), home

    def said(self, *args: str, code: int = 0) -> str:
        """Run a command to its end, and return its output; it must end with this code."""
        began = time.monotonic()
        done = subprocess.run([*self._command, *args], capture_output=True, text=True)
        print(f"  {time.monotonic() - began:4.1f} s  {' '.join(args)}", flush=True)  # noqa: T201  # its result
        if done.returncode != code or "Traceback" in done.stderr:
            sys.exit(f"exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def seen(self, text: str, *args: str) -> None:
        """Open a console in a terminal and wait for a text on its screen."""
        terminal = Terminal([*self._command, *args], self._home)
        try:
            terminal.wait_for(text)
        finally:
            terminal.close()
        print(f"   screen  {' '.join(args)}: {text}", flush=True)  # noqa: T201  # its result

    @contextmanager
    def serving(self, *args: str) -> Iterator[str]:
        """Run a server, and yield the URL on its first line."""
        command = [*self._command, *args]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
            assert child.stdout is not None
            try:
                yield child.stdout.readline().split()[-1]
            finally:
                child.terminate()

    def run(self) -> None:
        """Use everything that could be missing from a package."""
        assert self.said("--version") == f"fleet-tui, version {__version__}\n"
        assert "Read on:" in self.said("--help")
        assert self.said("config", "init") == (ROOT / "config.toml").read_text()
        assert "\n  security " in self.said("docs")
        assert self.said("docs", "cli") == (ROOT / "docs" / "cli.md").read_text()
        assert "complete -o" in self.said("completion", "bash")
        self.said("status", code=2)
        (self._home / "light.toml").write_text(LIGHT)
        self.said("check", "light.toml")
        with self.serving("sim", "--port", "0", "--kind", "nav2") as url:
            self.said("status", "--url", url)
            self.said("doctor", "--url", url)
            self.said("map", "show", url, "--floor", "floor_0")
            self.said("record", "shift.jsonl.gz", "--url", url, "--for", "2s")
            self.seen("robot_0", url)
        self.seen("robot_2", "replay", "shift.jsonl.gz")
        self.seen("robot_1", "demo")
        (self._home / "german.toml").write_text(LIGHT + 'language = "de"\n')
        self.seen("Flotte", "demo", "--config", "german.toml")
        with self.serving("serve", "--demo", "--port", "0") as url:
            assert url.startswith("http://127.0.0.1:")


def check(wheels: Path) -> None:
    """Try all three, without network."""
    subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
    for name in ("FLEET_TUI_CONFIG", "PYTHONPATH", "XDG_CACHE_HOME"):
        os.environ.pop(name, None)
    for way in WAYS:
        with TemporaryDirectory() as folder:
            os.environ["HOME"] = folder
            os.chdir(folder)
            print(f"{way}:", flush=True)  # noqa: T201  # a heading
            Trial(program(way, Path(folder), wheels), Path(folder)).run()


def main() -> None:
    """Collect wheels, then go on in a process without network."""
    if sys.argv[1:2] == [INSIDE]:
        check(Path(sys.argv[2]))
        return
    with TemporaryDirectory() as wheels:
        collect(Path(wheels))
        offline = ["unshare", "--map-root-user", "--net", sys.executable, "-m", "release.check"]
        sys.exit(subprocess.run([*offline, INSIDE, wheels], cwd=ROOT).returncode)


if __name__ == "__main__":
    main()
