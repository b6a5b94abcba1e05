"""Lines as dots."""

import numpy as np
import pytest

from fleet_tui.ui.view.map.tracing import trace


@pytest.mark.parametrize("far", [12.0, 1e6, 1e300, np.inf])
def test_a_line_is_cut_to_the_view_and_one_without_an_end_left_out(far: float) -> None:
    mask = np.zeros((4, 8), np.bool_)
    trace(mask, np.array([[-far, 1.5]]), np.array([[far, 1.5]]))
    assert mask.sum() == (8 if np.isfinite(far) and far < 1e300 else mask.sum())
    assert not mask[[0, 2, 3]].any()


def test_dashes_leave_gaps_and_what_is_done_is_left_out() -> None:
    start, stop = np.array([[0.0, 0.5]]), np.array([[15.9, 0.5]])
    dashed, rest = np.zeros((1, 16), np.bool_), np.zeros((1, 16), np.bool_)
    trace(dashed, start, stop, dashed=True)
    trace(rest, start, stop, done=0.5)
    assert 6 <= dashed.sum() <= 10
    assert not rest[0, :7].any() and rest[0, 9:].all()
