"""The diagnostics screen as tests open and read it."""

import re

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.console_pilot import Console

OVERHEARD = ["/rosout", "/diagnostics"]


def pane(it: Console) -> str:
    return it.pane("diagnostics-rows")


def say(server: RosbridgeServer, level: int, detail: str, node: str = "/robot_0/drive") -> None:
    server.bridge.publish_raw("/rosout", {"level": level, "name": node, "msg": detail})


async def open_page(it: Console, number: int, title: str) -> None:
    await it.press("d", str(number))
    await it.shows(title, "diagnostics-rows")


def lines(it: Console) -> int:
    """How many lines the log has, those of the bridge itself among them."""
    return int(re.findall(r" of (\d+) lines", it.text)[0])


async def listens(it: Console, server: RosbridgeServer) -> None:
    await it.until(lambda _: all(server.bridge.subscribers(topic) for topic in OVERHEARD))
