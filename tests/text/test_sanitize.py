"""Nothing hostile gets through, and widths are those of the terminal."""

import unicodedata

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from rich.cells import cell_len

from fleet_tui.text.sanitize import cell_width, fit, fit_words, folded, sanitize, without_cells


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("Base", "Base"),
        ("\x1b[2J", "␛[2J"),
        ("a\nb\tc\x00\x7f", "a␊b␉c␀␡"),
        ("\x9b31m", "\ufffd31m"),
        ("abc\u202edef", "abc\ufffddef"),
        ("\u2066x\u2069", "\ufffdx\ufffd"),
        ("a\u200bb\ufeff", "a\ufffdb\ufffd"),
        ("\u2028", "\ufffd"),
        ("\ud800", "\ufffd"),
        ("a\u00a0b", "a b"),
        ("仓库", "仓库"),
        ("e\u0301", "e\u0301"),
        ("\u0301x", "x"),
    ],
)
def test_visible(text: str, shown: str) -> None:
    assert sanitize(text) == shown


def test_a_tower_of_marks_is_cut_down() -> None:
    assert len(sanitize("a" + "\u0301" * 500)) <= 3


@given(st.text())
def test_nothing_unseen_is_left(text: str) -> None:
    shown = sanitize(text)
    assert not {unicodedata.category(letter) for letter in shown} & {"Cc", "Cf", "Cs", "Zl", "Zp"}
    assert sanitize(shown) == shown


@given(st.text(), st.integers(0, 30), st.booleans())
def test_fit_takes_exactly_its_cells(text: str, cells: int, right: bool) -> None:
    assert cell_width(fit(text, cells, right)) == cells


def test_fit_cuts_with_an_ellipsis_and_pads() -> None:
    assert fit("Consumidores", 6) == "Consu…"
    assert fit("仓库仓库", 6) == "仓库… "
    assert fit("7", 3, right=True) == "  7"


@given(st.text(st.characters(categories=["Lu", "Ll", "Nd", "Lo", "Sm"], max_codepoint=0xFFFF)))
def test_widths_agree_with_the_painter_where_it_matters(text: str) -> None:
    shown = "".join(letter for letter in sanitize(text) if cell_len(letter) in (1, 2))
    assert cell_width(shown) >= cell_len(shown)


@pytest.mark.parametrize(
    ("text", "cells", "shown"),
    [
        ("pose 25 s old cargo old", 17, "pose 25 s old…   "),
        ("pose 25 s old", 13, "pose 25 s old"),
        ("-> Workshop", 9, "-> Works…"),
        ("one two", 4, "one…"),
        ("one, two three", 9, "one, two…"),
        ("", 2, "  "),
    ],
)
def test_a_text_is_cut_after_a_whole_word_if_that_leaves_half_of_it(
    text: str, cells: int, shown: str
) -> None:
    assert fit_words(text, cells) == shown


@given(st.text(), st.integers(0, 30))
def test_cut_after_a_word_it_is_as_wide_as_its_cells(text: str, cells: int) -> None:
    assert cell_width(fit_words(text, cells)) == cells


@given(st.lists(st.text("ab/-", min_size=1, max_size=40), max_size=9), st.integers(1, 30), st.integers(1, 30))
def test_folded_lines_have_all_of_the_text_and_break_no_word_twice(
    words: list[str], first: int, others: int
) -> None:
    head, *rest = lines = folded(" ".join(words), first, others)
    assert len(head) <= first and all(len(line) <= others for line in rest)
    assert "".join(lines).replace(" ", "") == "".join(words)
    assert sum(line.count(" ") for line in lines) <= max(0, len(words) - 1), "no space within a word"


@given(st.text("a漢\u0301 ", max_size=40), st.integers(2, 30))
@example("漢漢漢漢 " + "a\u0301\u0301" * 4, 4)
def test_folded_lines_have_no_more_than_their_cells_beside_marks_either(text: str, cells: int) -> None:
    assert all(cell_width(line) <= cells for line in folded(text, cells, cells))


def test_a_long_word_goes_on_in_the_next_line() -> None:
    path = "/robot_7/Application_layout/Pause"
    assert folded(f"Service {path} is", 16, 30) == ["Service /robot_7", "/Application_layout/Pause is"]


@given(st.text("ab仓库", max_size=20), st.integers(0, 30), st.integers(0, 30))
def test_without_cells_a_text_is_shorter_by_them_and_keeps_its_start(
    text: str, start: int, cells: int
) -> None:
    gone = max(0, min(cells, cell_width(text) - start))
    assert cell_width(without_cells(text, start, cells)) == cell_width(text) - gone
    assert without_cells("仓库abc", 2, 3) == "仓 bc"[:1] + "bc"
