"""Transcripts of real bridges, and what of them a simulated one must have alike."""

import gzip
import json
from pathlib import Path
from typing import Any

from websockets.asyncio.client import ClientConnection

WIRE = Path(__file__).parent.parent / "wire"


# The recording's robots and floors, and ours that stand for them.
NAMES = {"/ground": "/floor_0", "/first": "/floor_1"}


Json = dict[str, Any]


def recording(name: str) -> list[Json]:
    path = WIRE / name
    text = gzip.decompress(path.read_bytes()).decode() if path.suffix == ".gz" else path.read_text()
    return [json.loads(line) for line in text.splitlines()]


def ours(text: str) -> str:
    for theirs, name in NAMES.items():
        text = text.replace(theirs, name)
    return text


def shape(value: object) -> object:
    """The structure of a value: its names in order, and the types of their values."""
    if isinstance(value, dict):
        return [(name, shape(inner)) for name, inner in value.items()]
    if isinstance(value, list):
        return [shape(inner) for inner in value[:1]]
    return type(value)


def frames(lines: list[Json], direction: str) -> list[str]:
    return [line["text"] for line in lines if line["dir"] == direction and "text" in line]


def parsed(text: str) -> Json:
    try:
        value: Json = json.loads(text)
    except ValueError:
        return {}
    return value


async def until_answer(client: ClientConnection, id_: str) -> Json:
    while True:
        frame = json.loads(await client.recv())
        if frame.get("id") == id_:
            answer: Json = frame
            return answer
