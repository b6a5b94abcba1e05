"""Keys that move in a recording while one is played."""

from collections.abc import Callable

from fleet_tui.actions import Actions, PlayerActions
from fleet_tui.keys.key import Key, Pane


def _player(
    id_: str, key: str, do: Callable[[PlayerActions], object], text: str, hint: str = ""
) -> Key[Actions]:
    return Key(id_, (key,), lambda actions: actions.play(do), text, pane=Pane.RECORDING, hint=hint)


RECORDING: tuple[Key[Actions], ...] = (
    _player("play", "space", lambda player: player.toggle(), "Play or stop", "play/stop"),
    _player("skip_back", "<", lambda player: player.skip(-10), "10 s back"),
    _player("skip_on", ">", lambda player: player.skip(10), "10 s on", "10 s"),
    _player("previous_mark", "(", lambda player: player.to_mark(-1), "Previous alarm, command or gap"),
    _player("next_mark", ")", lambda player: player.to_mark(1), "Next alarm, command or gap", "mark"),
    _player("step_back", ",", lambda player: player.step(-1), "One tick back: 0.1 s"),
    _player("step_on", ".", lambda player: player.step(1), "One tick on: 0.1 s", "step"),
    _player("record_back", ";", lambda player: player.step_record(-1), "One record back"),
    _player("record_on", "'", lambda player: player.step_record(1), "One record on: a message, or a fact"),
    _player("faster", "F", lambda player: player.change_speed(1), "Faster: up to x64", "faster"),
    _player("slower", "S", lambda player: player.change_speed(-1), "Slower: down to x0.25", "slower"),
    _player("usual_speed", "backspace", lambda player: player.change_speed(0), "As fast as it was"),
    Key(
        "go_to_time",
        ("@",),
        lambda do: do.view.go_to_time(),
        "Go to a time: 12:04:31, or +1m30s from the beginning",
        pane=Pane.RECORDING,
        hint="time",
        eager="opens",
    ),
    _player("to_beginning", "home", lambda player: player.to_end(-1), "To the beginning"),
    _player("to_the_end", "end", lambda player: player.to_end(1), "To the end"),
)
