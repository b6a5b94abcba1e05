"""A plain client of a bridge."""

import json
from collections.abc import Callable
from typing import Any

from websockets.asyncio.client import ClientConnection

Json = dict[str, Any]


async def send(client: ClientConnection, op: str, **fields: object) -> None:
    await client.send(json.dumps({"op": op} | fields))


async def read(client: ClientConnection) -> Json:
    found: Json = json.loads(await client.recv())
    return found


async def read_until(client: ClientConnection, wanted: Callable[[Json], bool]) -> list[Json]:
    """All frames up to the first that is wanted, this one included."""
    found = [await read(client)]
    while not wanted(found[-1]):
        found.append(await read(client))
    return found


async def call(client: ClientConnection, service: str, args: object = None, id_: str = "c") -> Json:
    await send(client, "call_service", service=service, args=args, id=id_)
    return (await read_until(client, lambda frame: frame.get("id") == id_))[-1]


async def frames_before_an_answer(client: ClientConnection) -> list[Json]:
    """Everything that is said until a call sent now is answered: what is not in it was not said."""
    await send(client, "call_service", service="/rosapi/get_time", id="last")
    return (await read_until(client, lambda frame: frame.get("id") == "last"))[:-1]


async def subscribe(client: ClientConnection, topic: str, type_: str | None, **fields: object) -> None:
    typed = {} if type_ is None else {"type": type_}
    await send(client, "subscribe", topic=topic, queue_length=1, **typed, **fields)
