"""Transcripts of a bridge of ROS 2."""

from tests.support.transcripts import ours


def theirs(text: str) -> str:
    """What the recording's client sent, in our names."""
    return ours(text).replace("/upper", "/floor_1")
