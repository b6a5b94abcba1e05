"""JSON in texts: read with its field's name in errors, and written as one line for people."""

import pytest

from fleet_tui.robots.rmf.encoded import line_of, text_reader
from fleet_tui.robots.rmf.tasks import TaskUpdate
from fleet_tui.text.errors import WireError


@pytest.mark.parametrize(
    ("data", "problem"),
    [
        ("{", "truncated"),
        ('{"data": {}}', "booking"),
        ('{"data": {"booking": {"id": 7}}}', "booking.id"),
        ("[]", "got `array`"),
    ],
)
def test_bad_json_is_refused_with_the_name_of_its_field(data: str, problem: str) -> None:
    with pytest.raises(WireError, match=problem):
        text_reader(TaskUpdate)({"data": data})


def test_any_value_is_one_line() -> None:
    assert line_of({"a": [1, "x\n y"], "b": 2.5}) == "a: 1, x y, b: 2.5"
    assert len(line_of("x" * 10_000)) < 250


def test_no_depth_or_length_of_a_value_is_too_much() -> None:
    deep: list[object] = []
    for _ in range(5000):
        deep = [deep]
    assert line_of(deep) == "..."
    assert line_of({str(n): "x" for n in range(100_000)}).startswith("0: x, 1: x")
