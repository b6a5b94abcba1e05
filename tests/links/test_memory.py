"""Garbage is looked for on the network loop, where commands wait meanwhile: that must be short."""

import gc
import weakref
from collections.abc import Iterator

import pytest

from fleet_tui.links.memory import collect, freeze


@pytest.fixture
def thawed() -> Iterator[None]:
    yield
    gc.unfreeze()
    gc.freeze()  # for the tests after it: all modules and tests stay


class Ring:
    """Refers to itself: only a search finds it."""

    def __init__(self) -> None:
        self.own = self


@pytest.mark.usefixtures("thawed")
def test_what_stays_is_not_looked_through_again() -> None:
    stays = [Ring() for _ in range(1000)]
    freeze()
    searched = {id(one) for one in gc.get_objects()}
    assert not any(id(ring) in searched for ring in stays)
    is_found = weakref.ref(Ring())
    collect()
    assert is_found() is None


@pytest.mark.usefixtures("thawed")
def test_what_is_garbage_by_then_is_found_first() -> None:
    is_found = weakref.ref(Ring())
    freeze()
    assert is_found() is None
