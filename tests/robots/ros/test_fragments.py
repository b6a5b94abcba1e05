"""Pieces of a message, put together in any order and bounded."""

import pytest

from fleet_tui.robots.ros.fragments import MOST_MESSAGES, Fragments
from fleet_tui.robots.ros.operations import Fragment
from fleet_tui.text.errors import WireError


def piece(id_: str, num: int, total: int, data: str = "x") -> Fragment:
    return Fragment(id_, data, num, total)


def test_pieces_are_put_together_in_any_order_and_bounded() -> None:
    pieces = Fragments(limit=10)
    assert [pieces.add(one) for one in (piece("a", 1, 2, "B"), piece("b", 0, 1, "C"))] == [None, b"C"]
    assert pieces.add(piece("a", 0, 2, "A")) == b"AB"
    for wrong in (piece("a", 2, 2), piece("a", -1, 2), piece("a", 0, 0), piece("a", 0, 10**6)):
        with pytest.raises(WireError):
            pieces.add(wrong)
    with pytest.raises(WireError, match="exceeds the limit"):
        pieces.add(piece("a", 0, 2, "x" * 11))
    for n in range(MOST_MESSAGES + 1):
        assert pieces.add(piece(str(n), 0, 2, "A")) is None
    assert pieces.add(piece("0", 1, 2, "B")) is None  # its first piece was let go
    assert pieces.add(piece(str(MOST_MESSAGES), 1, 2, "B")) == b"AB"
    pieces.clear()
    assert pieces.add(piece("3", 1, 2, "B")) is None
