"""Transcripts of a bridge of ROS 2."""

from tests.support.transcripts import ours


def theirs(text: str) -> str:
    """The operations of the recording's client, in our names."""
    return ours(text).replace("/upper", "/floor_1")
