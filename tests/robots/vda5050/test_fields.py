"""A wrong field is named and left out."""

import pytest

from fleet_tui.robots.vda5050.fields import LARGEST, Fields
from fleet_tui.text.errors import WireError


def test_each_value_is_read_by_the_first_name_that_has_one() -> None:
    fields = Fields.of(
        b'{"a": null, "b": 2, "t": "x", "f": true, "w": "teach_In", "p": {"n": 1}, "l": [{"n": 2}]}'
    )
    assert fields.number("a", "b") == 2.0 and fields.text("t") == "x" and fields.flag("f") is True
    assert fields.word("w") == "TEACHIN"
    part, parts = fields.part("p"), fields.parts(5, "l")
    assert part is not None and part.number("n") == 1.0
    assert parts is not None and [one.number("n") for one in parts] == [2.0]
    assert fields.number("none") is None and fields.parts(5, "none") is None and fields.text("none") == ""
    assert fields.faults == []


def test_what_is_wrong_is_named_with_its_path() -> None:
    fields = Fields.of(b'{"p": {"n": "x"}, "l": [1], "f": 1, "big": 1e999, "t": 3, "many": [{}, {}, {}]}')
    part = fields.part("p")
    assert part is not None and part.number("n") is None
    assert fields.parts(5, "l") == [] and fields.flag("f") is None
    assert fields.text("t") == "" and fields.id("t") == "3"
    assert fields.number("big") is None
    assert len(fields.parts(2, "many") or []) == 2
    assert fields.faults == [
        "p.n is 'x', not a number",
        "l[0] is not an object",
        "f is 1, not true or false",
        "t is 3, not text",
        "big is inf, not a number",
    ]


@pytest.mark.parametrize("payload", [b"", b"[]", b"{", b"\xff", b"[" * 10_000, b" " * (LARGEST + 1)])
def test_what_is_no_object_is_rejected(payload: bytes) -> None:
    with pytest.raises(WireError):
        Fields.of(payload)
