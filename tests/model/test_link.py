"""The state of a bridge as an operator needs to know it."""

import pytest

from fleet_tui.model.link import CommandPath, LinkState, Phase
from fleet_tui.text.language import Message


@pytest.mark.parametrize(
    ("link", "starting"),
    [
        (LinkState("a", "ws://a"), True),
        (LinkState("a", "ws://a", reason=Message("nothing listens there")), False),
        (LinkState("a", "ws://a", Phase.WAITING), False),
        (LinkState("a", "ws://a", Phase.UP), True),
        (LinkState("a", "ws://a", Phase.UP, commands_connected=True), False),
        (LinkState("a", "ws://a", Phase.UP, command_path=CommandPath.ALIVE), False),
    ],
)
def test_it_is_starting_until_something_speaks_against_it(link: LinkState, starting: bool) -> None:
    assert link.is_starting is starting


def test_a_bag_is_told_by_its_address() -> None:
    assert LinkState("a", "rosbag://night.bag").is_bag and not LinkState("a", "ws://bag").is_bag
