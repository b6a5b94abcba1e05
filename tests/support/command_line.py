"""The command line as a process."""

import os
import subprocess
import tempfile
from pathlib import Path

from tests.support.warm_cli import warm_cli

WITHIN = 55.0
"""Seconds, fewer than pytest waits for a test."""


def run(*args: str, cwd: Path, **env: str) -> subprocess.CompletedProcess[str]:
    """Run `fleet-tui` to its end."""
    environment = {**os.environ, "XDG_CONFIG_HOME": str(cwd), "XDG_STATE_HOME": str(cwd), **env}
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, Path(os.devnull).open() as nothing:
        streams = [nothing.fileno(), out.fileno(), err.fileno()]
        with warm_cli().start(args, cwd, environment, streams) as ended:
            ended.settimeout(WITHIN)
            _, code = b"".join(iter(lambda: ended.recv(20), b"")).split()
        said = [(file.seek(0), file.read().decode())[1] for file in (out, err)]
    return subprocess.CompletedProcess(args, int(code), *said)
