"""The command line, for tests that need no loop."""

import os
import subprocess
from pathlib import Path

from tests.support.cli import command


def run(*args: str, cwd: Path, **env: str) -> subprocess.CompletedProcess[str]:
    """Run `fleet-tui` to its end."""
    environment = {**os.environ, "XDG_CONFIG_HOME": str(cwd), "XDG_STATE_HOME": str(cwd), **env}
    ended = command(args, cwd, environment)
    return subprocess.CompletedProcess(args, ended.code, ended.out, ended.err)
