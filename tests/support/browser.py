"""A headless chromium, driven by the DevTools protocol over its websocket."""

import asyncio
import base64
import json
import os
import shutil
import signal
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from itertools import count
from pathlib import Path
from typing import Any
from urllib.request import urlopen

from websockets.asyncio.client import ClientConnection, connect

from tests.support.polling import HANGS
from tests.support.serve import until

PATIENCE = 30.0

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)

# textual.js keeps its terminal to itself; what xterm.js makes of the bytes is found when it is opened.
_WATCH = """
Object.defineProperty(Object.prototype, "_addonManager", {
  configurable: true,
  set(value) {
    Object.defineProperty(this, "_addonManager", {value, writable: true, configurable: true});
    window.seen = this;
  },
});
"""
_TEXT = """
(() => {
  if (!window.seen) return "";
  const {cols, rows, buffer} = window.seen;
  const line = (row) => buffer.active.getLine(row)?.translateToString(false, 0, cols) ?? "";
  return [...Array(rows).keys()].map(line).join("\\n");
})()
"""


class Browser:
    """One tab."""

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket
        self._numbers = count(1)
        self._waiting: dict[int, asyncio.Future[dict[str, Any]]] = {}
        self.asked: list[str] = []
        """The addresses it sent requests to."""
        self.errors: list[str] = []

    async def read(self) -> None:
        async for text in self._socket:
            match json.loads(text):
                case {"id": number, **answer}:
                    self._waiting.pop(int(number)).set_result({str(name): answer[name] for name in answer})
                case {"method": "Network.requestWillBeSent", "params": {"request": {"url": url}}}:
                    self.asked.append(url)
                case {"method": "Network.webSocketCreated", "params": {"url": url}}:
                    self.asked.append(url)
                case {"method": "Runtime.exceptionThrown" | "Log.entryAdded", "params": what}:
                    self.errors.append(json.dumps(what))

    async def call(self, method: str, **params: object) -> dict[str, Any]:
        number = next(self._numbers)
        self._waiting[number] = asyncio.get_running_loop().create_future()
        await self._socket.send(json.dumps({"id": number, "method": method, "params": params}))
        answer = await asyncio.wait_for(self._waiting[number], HANGS)
        assert "error" not in answer, answer
        result: dict[str, Any] = answer["result"]
        return result

    async def evaluate(self, code: str) -> Any:
        answer = await self.call("Runtime.evaluate", expression=code)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    async def go(self, url: str) -> None:
        for domain in ("Page", "Network", "Runtime", "Log"):
            await self.call(f"{domain}.enable")
        await self.call("Page.addScriptToEvaluateOnNewDocument", source=_WATCH)
        await self.call("Page.navigate", url=url)

    async def text(self) -> str:
        """The text of the terminal in the page."""
        return str(await self.evaluate(_TEXT))

    async def notice(self) -> str:
        """The message of the page over the terminal."""
        bar = "document.getElementById('notice')"
        return str(await self.evaluate(f"{bar}.hidden ? '' : {bar}.innerText"))

    async def until_true(self, code: str) -> None:
        """Wait until JavaScript holds in the page."""

        async def look() -> str:
            return str(bool(await self.evaluate(f"Boolean({code})")))

        await self._until(look, lambda text: text == "True")

    async def shows(self, detail: str) -> str:
        return await self._until(self.text, lambda text: detail in text)

    async def shows_no_longer(self, detail: str) -> None:
        await self._until(self.text, lambda text: detail not in text)

    async def has_rows(self, low: int, high: int) -> list[str]:
        """The text as soon as it is painted in so many rows."""
        text = await self._until(
            self.text, lambda text: low <= text.count("\n") < high and "? help" in text.split("\n")[-1]
        )
        return text.split("\n")

    async def says(self, detail: str) -> str:
        return await self._until(self.notice, lambda text: detail in text)

    async def says_nothing(self) -> None:
        await self._until(self.notice, lambda text: not text)

    async def _until(self, look: Callable[[], Awaitable[str]], holds: Callable[[str], bool]) -> str:
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if holds(text := await look()):
                return text
            await asyncio.sleep(0.05)
        raise AssertionError(f"{text}\n{self.errors}")

    async def press(self, key: str) -> None:
        more = {"text": key} if len(key) == 1 else {}
        code = {"Escape": 27}.get(key, 0)
        for kind in ("keyDown", "keyUp"):
            said = more if kind == "keyDown" else {}
            await self.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, **said)

    async def resize(self, width: int, height: int) -> None:
        """The window, in pixels."""
        await self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    async def picture(self) -> bytes:
        """A screenshot as PNG."""
        return base64.b64decode((await self.call("Page.captureScreenshot"))["data"])


@asynccontextmanager
async def browser(folder: Path) -> AsyncIterator[Browser]:
    """A browser with a fresh profile, and nothing that it does by itself."""
    assert CHROMIUM
    profile = folder / "chromium"
    process = await asyncio.create_subprocess_exec(
        CHROMIUM,
        *("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"),
        *("--remote-debugging-port=0", f"--user-data-dir={profile}", "--window-size=1200,840", "about:blank"),
        env={**os.environ, "HOME": str(folder)},
        stdout=asyncio.subprocess.DEVNULL,
        stderr=asyncio.subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        port_file = profile / "DevToolsActivePort"
        await until(lambda: port_file.exists() and port_file.read_text().count("\n"))
        port = port_file.read_text().splitlines()[0]
        async with _tab(port) as tab:
            yield tab
    finally:
        os.killpg(process.pid, signal.SIGKILL)
        await process.wait()


@asynccontextmanager
async def _tab(port: str) -> AsyncIterator[Browser]:
    def ask() -> list[dict[str, str]]:
        with urlopen(f"http://127.0.0.1:{port}/json", timeout=10) as answer:
            found: list[dict[str, str]] = json.load(answer)
            return found

    pages = [one for one in await asyncio.to_thread(ask) if one["type"] == "page"]
    async with connect(pages[0]["webSocketDebuggerUrl"], max_size=None) as socket:
        tab = Browser(socket)
        reading = asyncio.create_task(tab.read())
        try:
            yield tab
        finally:
            reading.cancel()
