"""Details of an outcome, as one line adds them."""

import pytest

from fleet_tui.text.details import detail_text


@pytest.mark.parametrize(
    ("detail", "text"), [("", ""), ("by the robot", " by the robot"), ("no cargo", " (no cargo)")]
)
def test_who_did_it_follows_and_a_reason_stands_in_brackets(detail: str, text: str) -> None:
    assert detail_text(detail) == text
