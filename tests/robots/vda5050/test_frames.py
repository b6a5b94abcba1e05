"""Tests of robots/vda5050/frames."""

import pytest

from fleet_tui.robots.vda5050.frames import BrokerMessage, frame_of, message_of
from fleet_tui.text.errors import WireError


@pytest.mark.parametrize("payload", [b"{}", b"", b"two\nlines", b"\xff\xfe\n"])
@pytest.mark.parametrize("kept", [False, True])
def test_a_message_comes_back_from_its_frame(payload: bytes, kept: bool) -> None:
    message = BrokerMessage('a/b "c"\n', payload, kept)
    frame, is_binary = frame_of(message)
    assert message_of(frame) == message and is_binary is (b"\xff" in payload)


@pytest.mark.parametrize("frame", [b"", b"{}", b"[]\n{}", b"\xff\n"])
def test_a_frame_without_a_topic_is_rejected(frame: bytes) -> None:
    with pytest.raises(WireError):
        message_of(frame)
