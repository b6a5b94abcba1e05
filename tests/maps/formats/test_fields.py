"""Values of graph files, one by one."""

import pytest

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.yaml_text import PlainText
from fleet_tui.text.errors import GraphError


def test_numbers_names_and_flags() -> None:
    assert (fields.number(PlainText("1e3"), "x"), fields.number(2, "x")) == (1000.0, 2.0)
    assert (fields.number(" -1.5e-3 ", "x"), fields.text(1.0, "x")) == (-0.0015, "1")
    assert (fields.text(PlainText("yes"), "x"), fields.text(7, "x")) == ("yes", "7")
    assert fields.flag(PlainText("true"), "x") and not fields.flag(False, "x")
    assert fields.elements(None, "x", 1) == [] and fields.optional_mapping("", "x") == {}
    assert fields.place([1, 2.0, PlainText("3")], "x") == (1.0, 2.0, 3.0)


@pytest.mark.parametrize("value", [True, "1 m", "", PlainText("a"), None, [1], 10**400])
def test_what_is_no_number(value: object) -> None:
    with pytest.raises(GraphError, match=r"^here: "):
        fields.number(value, "here")


def test_limits() -> None:
    with pytest.raises(GraphError, match="5 elements, at most 4 are supported"):
        fields.elements([0] * 5, "here", 4)
    with pytest.raises(GraphError, match="a text of 1,001 characters"):
        fields.text("x" * 1001, "here")
    with pytest.raises(GraphError, match="unknown vertex 9, the last one is 4"):
        fields.index(9, 5, "here")
