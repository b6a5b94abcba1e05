"""One fact has one word in row, `w`, alarm and title, and no calm sign stands beside what needs a person."""

import re
from functools import cache

import pytest

from tests.support.situation_matrix import EARLY, FAULTS, LATE, PAGE, Told, matrix, page

CASES = [(fault, seconds) for fault in FAULTS for seconds in (EARLY, LATE)]
WORDS = {
    "obstacle": "obstacle",
    "stuck": "stuck",
    "silent": "never seen",
    "stale": "pose missing",
    "mislocalised": "pose doubtful",
    "refuse": "refused",
    "restart": "lost: order",
    "foreign-cancel": "cancelled elsewhere",
}
"""The word of each fault once it is an alarm."""


@cache
def found() -> dict[tuple[str, int], Told]:
    return matrix()


def test_the_page_of_situations_is_what_the_console_says() -> None:
    assert PAGE.read_text() == page(found()), "python -m tests.support.situation_matrix writes it"


@pytest.mark.parametrize("fault", WORDS)
def test_row_and_alarm_have_the_same_word(fault: str) -> None:
    cases = [found()[fault, seconds] for seconds in (EARLY, LATE)]
    alarmed = [one for one in cases if any(WORDS[fault] in text for text in one.alarms)]
    assert alarmed, "it is an alarm at one of the two moments"
    assert all(WORDS[fault] in one.row for one in alarmed)


@pytest.mark.parametrize("fault", ["obstacle", "stuck", "silent", "stale", "mislocalised"])
def test_the_first_reason_begins_with_the_word_of_the_alarm(fault: str) -> None:
    assert found()[fault, LATE].first.startswith(WORDS[fault])


@pytest.mark.parametrize("case", CASES, ids=str)
def test_no_calm_sign_stands_beside_what_needs_a_person(case: tuple[str, int]) -> None:
    one = found()[case]
    assert bool(one.attention) is (one.code == 1)
    is_calm = "0 alarms" in one.top and "to look at" not in one.top
    assert not (is_calm and one.attention)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_counts_of_the_title_add_up_to_the_robots_online(case: tuple[str, int]) -> None:
    online, _, counts = found()[case].title.removeprefix("Fleet ").partition(" of 2 online")
    assert sum(int(number) for number in re.findall(r"\d+", counts)) == int(online)
