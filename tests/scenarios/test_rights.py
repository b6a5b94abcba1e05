"""A user who may only view, tried as a real Unix user with the real file at its real place.

In a mount namespace of its own: /etc of this machine stays as it is.
"""

import asyncio
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import AsyncIterator, Iterator
from pathlib import Path

import pytest

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import config_file, started
from tests.support.polling import HANGS
from tests.support.serve import serving
from tests.support.terminal_session import InTerminal

ROOT, NOBODY = Path(__file__).parents[2], 65534
AS_NOBODY = f"""#!/bin/sh
exec unshare -m sh -c 'mount --bind "$1" /etc && shift && exec setpriv --reuid {NOBODY} --regid {NOBODY} \\
  --clear-groups "$@"' sh "$ETC" "$PYTHON" "$@"
"""
NEEDED = ("passwd", "group", "hosts", "nsswitch.conf", "ld.so.cache", "localtime", "terminfo")
"""Parts of /etc that a process needs."""
PROGRAM = '[[programs]]\nname = "bridge"\nstart = ["true"]\nstop = ["true"]\nstatus = ["true"]\n'
NOT_ALLOWED = "not allowed: dispatch"


def can_be_nobody() -> str:
    """Return the reason that this can't be tried here, empty if it can."""
    if os.getuid() != 0:
        return "only root can become another user"
    tried = ["unshare", "-m", "sh", "-c", f"mount --bind /tmp /etc && exec setpriv --reuid {NOBODY} true"]
    try:
        ended = subprocess.run(tried, capture_output=True, check=False)
    except FileNotFoundError as missing:
        return f"no {missing.filename} here"
    return "no mount namespaces here" if ended.returncode else ""


def interpreter(paths: str) -> str:
    """Return a Python that nobody can run, also where this one is in a home; empty without one."""
    usual = f"/usr/bin/python3.{sys.version_info.minor}"
    for one in (sys.executable, usual):
        try:
            tried = [one, "-c", "import textual, fleet_tui"]
            ended = subprocess.run(
                tried,
                env={"PYTHONPATH": paths},
                cwd="/",
                check=False,
                user=NOBODY,
                group=NOBODY,
                extra_groups=[],
            )
        except OSError:
            continue
        if ended.returncode == 0:
            return one
    return ""


@pytest.fixture
def ground() -> Iterator[Path]:
    """A folder that everybody may enter: any other run of pytest closes its own again."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        yield Path(folder)


@pytest.fixture
def rights(ground: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Let `fleet-tui` run as nobody, below a file of rights that names somebody else."""
    if reason := can_be_nobody():
        pytest.skip(reason)
    etc = ground / "etc"
    (etc / "fleet-tui").mkdir(parents=True, mode=0o755)
    for name in NEEDED:
        place = Path("/etc") / name
        if place.is_file():
            shutil.copy(place, etc)
    file = etc / "fleet-tui" / "rights.toml"
    file.write_text('[dispatch]\nusers = ["ana"]\n')
    wrapper = ground / "python"
    wrapper.write_text(AS_NOBODY)
    wrapper.chmod(0o755)
    monkeypatch.setenv("ETC", str(etc))
    paths = os.pathsep.join([str(ROOT), sysconfig.get_path("purelib")])
    python = interpreter(paths)
    if not python:
        pytest.skip("no Python here that another user can run")
    monkeypatch.setenv("PYTHON", python)
    monkeypatch.setenv("PYTHONPATH", paths)
    for name in ("USER", "LOGNAME", "SUDO_USER"):
        monkeypatch.setenv(name, "ana")  # which count for nothing
    monkeypatch.setattr(sys, "executable", str(wrapper))
    yield file


@pytest.fixture
async def site(server: RosbridgeServer, rights: Path, ground: Path) -> AsyncIterator[Path]:
    """Return a home of nobody, with a configuration."""
    home = ground / "home"
    home.mkdir()
    config = config_file(home, server.url, robots=2, floors=2)
    config.write_text(config.read_text() + PROGRAM + '[operator]\nname = "ana"\n')
    (home / "routines").mkdir()
    (home / "routines" / "day.routine").write_text("robot_0: Base > Store\n")
    (home / "lines").write_text("robot_0 Base > Consumidores\npause all\n")
    for path in (home, *home.rglob("*")):
        os.chown(path, NOBODY, NOBODY)
    yield home


def write(rights: Path, text: str) -> None:
    rights.write_text(text)


def asked(server: RosbridgeServer) -> list[str]:
    """Return what robots were asked for, and what was published to them."""
    return [str(call) for call in server.bridge.services.calls]


async def end(home: Path, *words: str) -> tuple[int, str]:
    """Run a command to its end; return its code and what it said."""
    process = await started(home, *words)
    out, err = await asyncio.wait_for(process.communicate(), HANGS)
    return process.returncode or 0, (out + err).decode()


@pytest.mark.parametrize(
    "line",
    [
        "order robot_0 Base Consumidores --yes",
        "pause --all --timeout 5",
        "run lines",
        "routine run day",
        *(
            pytest.param(line, marks=pytest.mark.nightly)
            for line in (
                "cancel robot_0 1",
                "clear robot_0 --yes",
                "pause robot_0",
                "resume robot_0",
                "goto robot_0 1 1 --yes",
            )
        ),
    ],
)
async def test_who_may_only_view_commands_nothing_from_a_shell(
    server: RosbridgeServer, site: Path, line: str
) -> None:
    code, said = await end(site, *line.split())
    assert (code, NOT_ALLOWED in said) == (1, True), said
    assert asked(server) == []


@pytest.mark.parametrize("line", ["set-pose robot_0 1 1 0 --yes", "programs stop bridge --yes"])
async def test_setting_up_needs_its_own_right(
    server: RosbridgeServer, site: Path, rights: Path, line: str
) -> None:
    write(rights, '[dispatch]\nusers = ["nobody"]\n')
    code, said = await end(site, *line.split())
    assert (code, "not allowed: setup" in said) == (1, True), said
    assert asked(server) == []


async def test_who_may_dispatch_does_and_sees_why(server: RosbridgeServer, site: Path, rights: Path) -> None:
    write(rights, '[dispatch]\ngroups = ["nogroup", "nobody"]\n')
    code, said = await end(site, "order", "robot_0", "Base", "Consumidores", "--yes")
    assert code == 0 and asked(server), said
    _, said = await end(site, "rights")
    assert said.startswith("nobody: dispatch (")


async def test_a_file_that_somebody_else_may_have_written_lets_nobody_command(
    server: RosbridgeServer, site: Path, rights: Path
) -> None:
    write(rights, '[setup]\nusers = ["nobody"]\n')
    os.chown(rights, NOBODY, NOBODY)
    code, said = await end(site, "pause", "robot_0")
    assert code == 1 and f"{NOT_ALLOWED} (" in said and "is not owned by root" in said
    assert asked(server) == []


async def test_who_may_only_view_commands_nothing_from_the_console(
    server: RosbridgeServer, site: Path
) -> None:
    running = InTerminal(["--config", str(site / "config.toml")], site)
    try:
        await asyncio.to_thread(running.shows, "Consumidores")
        for keys in ("p", "P", ":pause all\r"):
            running.press(keys)
            await asyncio.to_thread(running.shows, NOT_ALLOWED)
            running.press("\x1b")
        footer = running.text().splitlines()[-1]
        assert "w why" in footer and "o order" not in footer and "p pause" not in footer
    finally:
        await asyncio.to_thread(running.close)
    assert asked(server) == []


@pytest.mark.nightly
async def test_a_tab_has_the_rights_of_its_user(server: RosbridgeServer, site: Path) -> None:
    async with serving(site, server.url, "--allow-commands") as it, it.tab() as page:
        await page.shows("Consumidores")
        await page.press("p")
        await page.shows(NOT_ALLOWED)
    assert asked(server) == []
