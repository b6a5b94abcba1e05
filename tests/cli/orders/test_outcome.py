"""Exit codes of commands."""

from fleet_tui.cli.orders.outcome import exit_code


def test_one_exit_code_for_several() -> None:
    assert [exit_code(codes) for codes in ([], [0, 0], [3, 3], [0, 3], [0, 1, 2], [2])] == [0, 0, 3, 1, 1, 2]
