"""Releases unused memory: large maps that are gone, garbage, free blocks of the C library."""

import ctypes
import gc
from collections.abc import Callable
from typing import Any

M_MMAP_THRESHOLD = -3  # malloc.h of glibc
LARGE = 128 * 1024
"""Size in bytes from which a freed block returns to the system at once. It costs the largest pictures of a
map half a millisecond; with 1 MiB memory kept growing."""


def _c_function(name: str) -> Callable[..., Any]:
    """Return a function of the C library, or a no-op if it has none of that name."""
    try:
        found: Callable[..., Any] = getattr(ctypes.CDLL(None), name)
    except (OSError, TypeError, AttributeError):
        return lambda *_: None
    return found


def tune_malloc() -> None:
    """Return large blocks to the system for good: glibc otherwise raises its threshold to the largest freed
    block."""
    _c_function("mallopt")(M_MMAP_THRESHOLD, LARGE)


def trim() -> None:
    """Return free memory to the system, if the C library retains it (glibc). Takes 1 to 5 ms."""
    _c_function("malloc_trim")(0)


def collect() -> None:
    """Collect garbage, which Python by itself does only after 10 minutes or more of a busy console, and
    release it. Takes 1 to 4 ms with 100 robots and a large map, once frozen."""
    gc.collect()
    trim()


def freeze() -> None:
    """Collect, then exclude all remaining objects from later collections. Takes 5 to 18 ms."""
    collect()
    gc.freeze()
