"""The keys of poses and goals."""

from fleet_tui.keys import KEYS, Pane
from fleet_tui.keys.keymap import keymap


def test_they_may_be_keys_of_the_map_and_of_the_editor() -> None:
    chosen, problems = keymap({})
    assert problems == []
    assert chosen["place_left"] == ("h",) and "h" in chosen["pan_left"]
    assert chosen["pose"] == chosen["edit_add_at_robot"] == ("I",)


def test_none_works_in_a_recording() -> None:
    assert all(key.only_live for key in KEYS if key.pane is Pane.PLACE or key.id in ("pose", "goal"))
