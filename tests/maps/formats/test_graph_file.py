"""Missing choices say which option would answer them."""

from fleet_tui.maps.formats.graph_file import MissingChoiceError
from fleet_tui.text.language import Message


def test_a_missing_choice_is_an_error_with_an_option() -> None:
    missing = MissingChoiceError(Message("choose"), "--floor", ("a", "b"))
    assert (str(missing), missing.option, missing.choices) == ("choose", "--floor", ("a", "b"))
