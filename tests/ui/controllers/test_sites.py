"""The `:site` command."""

from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.controllers.offers import typed_site
from fleet_tui.ui.controllers.typed import Typed
from tests.support.fleets import fleet
from tests.support.sites import two_sites


def typed(line: str, state: FleetState) -> tuple[Typed | None, list[str]]:
    found: list[str] = []
    result = typed_site(line, state, found.append)
    for _, do in result.entries if result else ():
        do()
    return result, found


def test_a_site_is_gone_to_by_its_name() -> None:
    result, found = typed("site south", two_sites())
    assert result and result.entries[0][0] == "Go to site south" and found == ["robot_1"]


def test_a_name_is_completed_and_an_unknown_one_answered() -> None:
    state = two_sites()
    beginning, _ = typed("site so", state)
    assert beginning and list(beginning.completed) == ["site south"]
    nothing, _ = typed("site", state)
    assert nothing and nothing.problem == "site NAME: north, south"
    unknown, _ = typed("site sotuh", state)
    assert unknown and unknown.problem.startswith("no site sotuh") and "south" in unknown.problem


def test_other_lines_and_consoles_of_one_site() -> None:
    assert typed("pause robot_0", two_sites())[0] is None
    alone, _ = typed("site south", fleet(1))
    assert alone and "one site" in alone.problem
