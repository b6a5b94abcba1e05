"""A simulated fleet that says what would harm a terminal wherever it can say anything. Prints its URL."""

import asyncio
import json
import os
import sys
from collections.abc import Callable
from dataclasses import replace
from itertools import cycle
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.server import RosbridgeServer

CLIPBOARD = "\x1b]52;c;aGFja2Vk\x07"
"""Would put `hacked` into the clipboard of whoever sits at the terminal."""
EVIL = [
    "\x1b[2J\x1b[1;1H\x1b[31mred",
    CLIPBOARD,
    "\x1b]0;title\x1b\\ \x1bP+q544e\x1b\\",
    "\x9b31mC1\x9d52;c;eA==\x9c",
    "\u202eevil\u2066\u200f",
    "[red]markup[/red][@click=app.quit]x[/] [/",
    "a\nb\r\tc\x00\x7f\x08\x08",
    "仓库" * 30,
    "👩\u200d👩\u200d👧 ✈\ufe0f",
    "e" + "\u0301" * 300,
    "zero\u200bwidth\ufeff\U000e0041",
    "long " * 20_000,
]
ROBOTS = 6
EVERY = 0.3
"""Seconds between frames that are no message at all."""


def _spoilt(topic: Topic, change: Callable[[Any, str], Any]) -> Topic:
    """The topic with its messages changed, with the next evil text each time."""
    texts = cycle(EVIL)

    def payload(now: float) -> Payload:
        return Payload(change(json.loads(topic.payload(now).json), next(texts)))

    return replace(topic, payload=payload)


def _labels(msg: Any, _text: str) -> Any:
    texts = cycle(EVIL)
    return {"vertices": [{**one, "label": f"{next(texts)}{one['label']}"} for one in msg["vertices"]]}


def _queue(msg: Any, text: str) -> Any:
    orders = [{"id": n, "start": n, "end": n + 1, "status": evil} for n, evil in enumerate(EVIL, 1)]
    return msg | {"orders": orders, "current_order_id": 3, "last_order_id": 99}


def _health(_msg: Any, _text: str) -> Any:
    values = [{"key": text, "value": text} for text in EVIL]
    parts = [
        {"level": 1, "name": text, "message": text, "hardware_id": text, "values": values} for text in EVIL
    ]
    return {"status": parts}


def _pose(msg: Any, text: str) -> Any:
    return msg | {"header": msg["header"] | {"frame_id": text}}


def _data(msg: Any, text: str) -> Any:
    return {"data": text}


def _evil(text: str) -> Callable[[dict[str, Any]], dict[str, Any]]:
    return lambda args: {
        "request_id": args.get("request_id", 0),
        "success": False,
        "status": f"REJECTED: {text}",
        "message": f"REJECTED: {text}",
    }


def _fails(_args: dict[str, Any]) -> dict[str, Any]:
    raise ServiceError(f"service responded with an error: {CLIPBOARD}")


def spoil(server: RosbridgeServer) -> None:
    """Robot 0 is well but for its labels and orders; robot 1 is nowhere; robot 2 sends no numbers."""
    topics = server.bridge.topics
    for name in list(topics):
        if name.endswith("labeled_vertices"):
            topics[name] = _spoilt(topics[name], _labels)
        elif name.endswith("queue"):
            topics[name] = _spoilt(topics[name], _queue)
    for text in EVIL[:-1]:
        name = f"/{text}/pose"
        topics[name] = replace(topics["/robot_0/pose"], name=name)
    topics["/robot_1/pose"] = _spoilt(topics["/robot_1/pose"], _pose)
    topics["/robot_2/battery"] = _spoilt(topics["/robot_2/battery"], _data)
    topics["/diagnostics"] = _spoilt(topics["/diagnostics"], _health)
    for number, service in enumerate(server.bridge.services.offered):
        server.bridge.services.answers[service] = (
            _fails if "Pause" in service else _evil(EVIL[number % len(EVIL)])
        )


def _frames(text: str) -> list[str | bytes]:
    return [
        json.dumps({"op": "status", "level": text, "msg": text}),
        json.dumps({"op": "status", "msg": {text: [text]}}),
        json.dumps({"op": text, "topic": text, "msg": {}}),
        json.dumps({"op": "publish", "topic": text, "msg": text}),
        json.dumps({"op": 7, text: text}),
        text.encode()[:1000],
        b"\xff" + text.encode()[:1000],
        json.dumps({"op": "service_response", "id": text, "values": {text: text}, "result": True}),
    ]


async def _serve() -> None:
    server = RosbridgeServer(OhFleet(ROBOTS, 2, seed=3))
    spoil(server)
    await server.start()
    print(server.url, flush=True)
    ended = asyncio.get_running_loop().run_in_executor(None, os.read, sys.stdin.fileno(), 1)
    for text in cycle(EVIL):
        for evil in EVIL:
            server.bridge.publish_raw("/rosout", {"level": 2, "name": evil, "msg": evil})
        for frame in _frames(text):
            await asyncio.wait([ended], timeout=EVERY)
            if ended.done():
                return
            server.bridge.publish_raw("/robot_0/pose", frame)


if __name__ == "__main__":
    asyncio.run(_serve())
