"""Transcripts of a bridge of ROS 2."""

from typing import Any

from tests.support.transcripts import frames, ours, parsed, recording


def theirs(text: str) -> str:
    """The operations of the recording's client, in our names."""
    return ours(text).replace("/upper", "/floor_1")


def recorded_answers(name: str) -> dict[str, dict[str, Any]]:
    """The recorded replies by their ids."""
    return {frame["id"]: frame for frame in map(parsed, frames(recording(name), "in")) if "id" in frame}


def given_up() -> str:
    """The recorded text for a call without an answer."""
    replies = recorded_answers("ros2-frozen-node.jsonl.gz").values()
    return next(str(reply["values"]) for reply in replies if not reply["result"])
