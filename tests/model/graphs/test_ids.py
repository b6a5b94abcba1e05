"""Ids of graph elements: new ones, and those that occur twice."""

from fleet_tui.model.graphs.ids import distinct, is_number, next_id, unused


def test_a_new_id_is_above_all_that_ever_were() -> None:
    assert next_id() == "0"
    assert next_id({"3": 1, "node-9": 1}, ["41"], ["-7"]) == "42"
    assert [one for one in ("0", "12", "-3", "", "007", "-0", "1.0", "²", "x") if is_number(one)] == [
        "0",
        "12",
        "-3",
    ]
    assert (unused("a", ()), unused("a", {"a", "a-2"})) == ("a", "a-3")


def test_the_last_of_several_keeps_the_id() -> None:
    assert distinct(["1", "a", "1", "a", "7"]) == [
        ("8", ("1",)),
        ("a-2", ("a",)),
        ("1", ()),
        ("a", ()),
        ("7", ()),
    ]
    assert distinct(["1", "1"], ["30"]) == [("31", ("1",)), ("1", ())]
