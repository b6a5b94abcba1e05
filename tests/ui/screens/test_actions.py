"""Every key has an action where it works, and keys of one name do the same."""

from fleet_tui.features.history.overlay import HistoryOverlay
from fleet_tui.keys import BY_ID, KEYS, Pane
from fleet_tui.ui.widgets.rows_pane import row_actions
from tests.support.planted_console import planted

OWN = (Pane.ROWS, Pane.DIAGNOSTICS, Pane.HISTORY)
"""Panes that run their keys themselves."""


async def test_every_key_has_an_action() -> None:
    async with planted() as it:
        features = it.app.main.features
        of_panes = [
            *row_actions(it.app.main.fleet),
            *features.diagnostics.actions,
            *it.app.main.query_one(HistoryOverlay).actions,
        ]
        assert sorted(of_panes) == sorted(key.id for key in KEYS if key.pane in OWN)
        of_player = {key.id for key in KEYS if key.pane is Pane.RECORDING} - {"go_to_time"}
        assert features.actions.keys() == BY_ID.keys() - {*of_panes} - of_player
        same = {"help": "help_anywhere", "pause_all": "pause_all_anywhere"}
        same |= {key.id: key.instead_of for key in KEYS if key.instead_of}
        assert all(features.actions[one] == features.actions[other] for one, other in same.items())
