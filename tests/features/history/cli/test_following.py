"""Lines of a service about its links."""

from fleet_tui.features.history.cli.collecting import Following
from tests.support.fleets import T0, fleet, link_lost, link_up, reduced


def test_each_change_once_with_the_reason() -> None:
    said: list[str] = []
    following = Following(said.append)
    begun = fleet()
    up = reduced(begun, link_up(T0))
    for state in (begun, up, reduced(up, link_lost(T0 + 1))):
        for notes in ([], ["history: not written: disk full"], ["history: not written: disk full"]):
            following.look(state, notes)
    url = next(iter(state.links.values())).url
    note = "history: not written: disk full"
    lost = f"{url}: no link: connection refused"
    assert said == [f"{url}: no link", note, f"{url}: connected", note, lost, note]
