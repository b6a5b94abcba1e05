"""Shared facts name their console."""

from fleet_tui.records.desk.facts import SharedNote


def test_the_id_begins_with_that_of_the_console() -> None:
    assert SharedNote("host-12-ab:7", "ana", 0.0, "x").console == "host-12-ab"
    assert SharedNote("odd", "ana", 0.0, "x").console == ""
