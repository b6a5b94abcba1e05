"""A second real user of this machine. Only root can act as one, and give files away."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

EVE = 65534
"""The user id of nobody."""
two_users = pytest.mark.skipif(os.getuid() != 0, reason="only root can become another user")


def give(*paths: Path) -> None:
    """Give files, folders or links to the other user."""
    for path in paths:
        os.chown(path, EVE, EVE, follow_symlinks=False)


def as_eve(act: Callable[[], object]) -> str:
    """Do something as the other user, in a process of its own; return what it gave, or the error."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.setgroups([])
            os.setgid(EVE)
            os.setuid(EVE)
            said = str(act())
        except Exception as problem:  # noqa: BLE001  # whatever it is, the test is told
            said = repr(problem)
        os.write(writing, said.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as answer:
        said = answer.read()
    os.waitpid(child, 0)
    return said
