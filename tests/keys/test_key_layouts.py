"""Every action has a key on keyboards where some characters are behind AltGr or are dead keys."""

from collections import defaultdict

import pytest

from fleet_tui.keys import KEYS, Pane
from tests.support.keyboards import NEEDS_ALTGR

SELECTS_OTHERWISE = {"next_robot", "previous_robot", "next_floor", "previous_floor"}
"""Numbers, the fleet and the palette select robots and floors in a recording, where `.` `,` `<` `>` step."""


def _typable(key: str, layout: str) -> bool:
    return key.rpartition("+")[2] not in NEEDS_ALTGR[layout]


@pytest.mark.parametrize("layout", NEEDS_ALTGR)
@pytest.mark.parametrize("in_recording", [False, True])
def test_every_action_has_a_key_without_altgr_and_dead_keys(layout: str, in_recording: bool) -> None:
    found = defaultdict[tuple[Pane, str], list[str]](list)
    for key in KEYS:
        if key.keys and not (key.only_live if in_recording else key.pane is Pane.RECORDING):
            found[key.pane, key.instead_of or key.id] += key.keys
    missing = {id_ for (_, id_), keys in found.items() if not any(_typable(key, layout) for key in keys)}
    assert missing == (SELECTS_OTHERWISE if in_recording else set())


@pytest.mark.parametrize("layout", NEEDS_ALTGR)
def test_the_key_that_is_named_needs_no_altgr(layout: str) -> None:
    plain = [key for key in KEYS if key.instead_of]
    assert plain and all(_typable(key.keys[0], layout) for key in plain)
    assert all(not _typable(key.keys[0], layout) for one in plain for key in KEYS if key.id == one.instead_of)
