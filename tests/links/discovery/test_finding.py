"""Findings: near names, lists and short times in words."""

from fleet_tui.links.discovery.finding import Finding, Verdict, listed, milliseconds, nearest


def test_only_a_fail_is_a_failure() -> None:
    found = [Finding("robot_0", "pose", verdict, "x").is_failure for verdict in Verdict]
    assert found == [False, False, True, False]


def test_names_that_look_like_one() -> None:
    assert nearest("/robot_0/battry", ["/robot_0/battery", "/map"]) == ["/robot_0/battery"]
    assert nearest("x", []) == []


def test_of_many_names_the_first_ones() -> None:
    assert listed(["a", "b"]) == "a, b"
    assert listed(["a", "b", "c", "d", "e"]) == "a, b, c and 2 more"


def test_short_times() -> None:
    assert (milliseconds(0.0123), milliseconds(0.5)) == ("12.3 ms", "0.50 s")
