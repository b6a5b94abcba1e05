"""Which names and pages are ours."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.serve.guard import is_loopback, is_ours, is_same_origin, names_of

LOOPBACK = names_of("127.0.0.1")


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8000", "localhost:9", "LOCALHOST", "[::1]:8000", "192.168.1.9:8000"]
)
def test_addresses_and_localhost_are_ours(host: str) -> None:
    assert is_ours(host, LOOPBACK)


@pytest.mark.parametrize(
    "host",
    ["", ":8000", "evil.example", "127.0.0.1.evil.example:8000", "localhost.evil.example", "[::1", "a@b:c"],
)
def test_other_names_are_not(host: str) -> None:
    assert not is_ours(host, LOOPBACK)


@given(st.text(max_size=30))
def test_any_host_is_answered(host: str) -> None:
    assert is_ours(host, LOOPBACK) in (True, False)


def test_the_name_it_was_given_is_ours() -> None:
    assert is_ours("robots.example:8000", names_of("robots.example"))


@pytest.mark.parametrize(
    ("origin", "same"),
    [
        ("http://localhost:8000", True),
        ("https://localhost:8000", True),  # behind something that speaks TLS
        ("http://localhost:8001", False),
        ("http://evil.example", False),
        ("file://localhost:8000", False),
        ("null", False),
        ("", False),
    ],
)
def test_a_page_is_ours_if_it_came_from_here(origin: str, same: bool) -> None:
    assert is_same_origin(origin, "localhost:8000") is same


@pytest.mark.parametrize(
    ("host", "alone"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("localhost", True),
        ("0.0.0.0", False),
        ("::", False),
        ("robots", False),
        ("", False),
    ],
)
def test_loopback_is_known(host: str, alone: bool) -> None:
    assert is_loopback(host) is alone
