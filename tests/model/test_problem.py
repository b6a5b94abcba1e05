"""Rights include each other, and say what is lacking."""

from fleet_tui.model.problem import Permissions, Right


def test_setup_includes_dispatch_and_dispatch_to_view() -> None:
    assert Right.VIEW < Right.DISPATCH < Right.SETUP
    assert [right.word for right in Right] == ["view", "dispatch", "setup"]
    dispatcher = Permissions(right=Right.DISPATCH)
    assert dispatcher.refusal(Right.VIEW) == dispatcher.refusal(Right.DISPATCH) == ""
    assert dispatcher.refusal(Right.SETUP) == "not allowed: setup"
