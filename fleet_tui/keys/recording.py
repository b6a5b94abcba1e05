"""Keys that move in a recording while one is played."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import EMPTY, Message


def _player(id_: str, key: str, text: Message, hint: Message = EMPTY) -> Key:
    return Key(id_, (key,), text, pane=Pane.RECORDING, hint=hint)


RECORDING: tuple[Key, ...] = (
    _player("play", "space", Message("Play or pause"), Message("play/stop")),
    _player("skip_back", "<", Message("Skip back 10 s")),
    _player("skip_on", ">", Message("Skip forward 10 s"), Message("10 s")),
    _player("previous_mark", "(", Message("Previous alarm, command or gap")),
    _player("next_mark", ")", Message("Next alarm, command or gap"), Message("mark")),
    _player("step_back", ",", Message("Step back one tick (0.1 s)")),
    _player("step_on", ".", Message("Step forward one tick (0.1 s)"), Message("step")),
    _player("record_back", ";", Message("Step back one record")),
    _player("record_on", "'", Message("Step forward one record")),
    _player("faster", "F", Message("Play faster, up to x64"), Message("faster")),
    _player("slower", "S", Message("Play slower, down to x0.25"), Message("slower")),
    _player("usual_speed", "backspace", Message("Play at original speed")),
    Key(
        "go_to_time",
        ("@", "ctrl+g"),
        Message("Go to a time: 12:04:31, or +1m30s from the start"),
        pane=Pane.RECORDING,
        hint=Message("time"),
    ),
    _player("to_beginning", "home", Message("Go to the start")),
    _player("to_the_end", "end", Message("Go to the end")),
)
