"""Gives back what nobody needs any more: large maps that have gone, garbage, the C library's hoard."""

import ctypes
import gc
from collections.abc import Callable
from typing import Any

M_MMAP_THRESHOLD = -3  # malloc.h of glibc
LARGE = 128 * 1024
"""Bytes of a block that goes back to the system as soon as it is free. It costs the largest pictures of a map
half a millisecond; with 1 MiB memory went on growing."""


def _c_function(name: str) -> Callable[..., Any]:
    """A function of the C library, or one that does nothing where there is none of that name."""
    try:
        found: Callable[..., Any] = getattr(ctypes.CDLL(None), name)
    except (OSError, TypeError, AttributeError):
        return lambda *_: None
    return found


def tune_malloc() -> None:
    """Let large blocks go back for good: else glibc keeps all up to the size of the largest that ever did."""
    _c_function("mallopt")(M_MMAP_THRESHOLD, LARGE)


def trim() -> None:
    """Return free memory to the system, where the C library hoards it (glibc). Takes 1 to 5 ms."""
    _c_function("malloc_trim")(0)


def collect() -> None:
    """Look for garbage, which Python by itself does after 10 minutes or more of a console at work, and give
    it back. Takes 1 to 4 ms with 100 robots and a large map, once settled."""
    gc.collect()
    trim()


def freeze() -> None:
    """Tidy, and never look again through what is left: it stays as long as the console. Takes 5 to 18 ms."""
    collect()
    gc.freeze()
