"""Runs cover exactly the width, wide characters stay whole, changes are found."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.text.sanitize import cell_width, sanitize
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole

texts = st.text(st.sampled_from("abz仓库한 ·▶e\u0301"), max_size=8)
writes = st.lists(st.tuples(st.integers(-4, 14), st.integers(-1, 3), texts, st.sampled_from(list(StyleRole))))


@given(writes)
def test_runs_cover_exactly_the_width(written: list[tuple[int, int, str, StyleRole]]) -> None:
    cells = Cells.blank(12, 3, StyleRole.FLOOR)
    for x, y, text, role in written:
        cells.write(x, y, sanitize(text), role)
    for y, runs in enumerate(cells.all_runs()):
        assert sum(cell_width(text) for text, _ in runs) == 12
        assert all(runs[i][1] != runs[i + 1][1] for i in range(len(runs) - 1))
        assert runs == cells.runs(y)


@given(writes, writes)
def test_changes_are_exactly_what_differs(
    first: list[tuple[int, int, str, StyleRole]], then: list[tuple[int, int, str, StyleRole]]
) -> None:
    before = Cells.blank(12, 3, StyleRole.FLOOR)
    for x, y, text, role in first:
        before.write(x, y, text, role)
    after = before.copy()
    for x, y, text, role in then:
        after.write(x, y, text, role)
    patched = before.copy()
    for y, start, end in after.changes(before):
        assert start < end
        patched.codes[y, start:end] = after.codes[y, start:end]
        patched.roles[y, start:end] = after.roles[y, start:end]
    assert np.array_equal(patched.codes, after.codes)
    assert np.array_equal(patched.roles, after.roles)


narrow = st.text("ab▶‖", max_size=5)
robots = st.lists(
    st.tuples(st.integers(-4, 14), st.integers(-1, 3), narrow, st.sampled_from(list(StyleRole))), max_size=9
)


@given(robots, st.sampled_from((1, 50)))
def test_many_texts_at_once_are_the_same_as_one_after_the_other(
    robots: list[tuple[int, int, str, StyleRole]], times: int
) -> None:
    written = robots * times
    once = Cells.blank(12, 3, StyleRole.FLOOR)
    for y in range(3):
        once.write(y % 2, y, "仓" * 6, StyleRole.LABEL)
    singly = once.copy()
    once.write_all(written)
    for x, y, text, role in written:
        singly.write(x, y, text, role)
    assert np.array_equal(once.codes, singly.codes)
    assert np.array_equal(once.roles, singly.roles)


def test_a_wide_character_loses_both_halves() -> None:
    cells = Cells.blank(6, 1, StyleRole.FLOOR)
    cells.write(1, 0, "仓", StyleRole.LABEL)
    cells.write(2, 0, "x", StyleRole.ROBOT)
    assert cells.text() == "  x   "
    cells.write(4, 0, "仓", StyleRole.LABEL)
    cells.write(4, 0, "y", StyleRole.LABEL)
    assert cells.text() == "  x y "


def test_what_does_not_fit_is_left_out() -> None:
    cells = Cells.blank(4, 1, StyleRole.FLOOR)
    cells.write(3, 0, "仓", StyleRole.LABEL)
    cells.write(-1, 0, "仓a", StyleRole.LABEL)
    assert cells.text() == " a  "
    cells.write(-9, 0, "far", StyleRole.LABEL)
    cells.write(99, 0, "far", StyleRole.LABEL)
    assert cells.text() == " a  "


def test_everything_changed_for_another_size() -> None:
    assert Cells.blank(3, 2, StyleRole.FLOOR).changes(Cells.blank(4, 2, StyleRole.FLOOR)) == [
        (0, 0, 3),
        (1, 0, 3),
    ]
