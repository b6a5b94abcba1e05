"""Fixtures of the link's tests."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from tests.support.nav2_site import Site, nav2_site


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    """Two quiet robots with Nav2."""
    async with nav2_site(tmp_path) as running:
        yield running
