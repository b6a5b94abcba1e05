"""The web server: one page, and a console for each open tab."""

import asyncio
import logging
import os
import signal
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib import resources
from json import JSONDecodeError

import textual_serve
from aiohttp import WSCloseCode, WSMsgType, web
from textual_serve.app_service import AppService
from textual_serve.download_manager import DownloadManager

from fleet_tui.config.log_file import log_to_file
from fleet_tui.features.serve.guard import guard, is_loopback, say_policy
from fleet_tui.signals import stopped_by_signal
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

MOST_TABS = 8
"""Maximum number of consoles, each a process of some 90 MB."""
WAIT_FOR_A_PLACE = 3.0
"""Seconds to wait for a free console: a reloaded page releases one and requests one."""
HEARTBEAT = 30.0
"""Seconds between two pings. A page without an answer for half that time is gone; a busy machine or a slow
tunnel may delay one for seconds."""
LONGEST_MESSAGE = 2**20
"""Maximum bytes from a page: a paste."""

Say = Callable[[str], object]


PATIENCE = 1.5
"""Seconds for a console to end by itself once its tab is closed."""
KILLED = 10.0
"""Seconds for a busy machine to end what was killed."""
WIDEST = 1000
HIGHEST = 500
"""Maximum cells; a page may send any number."""

SETTINGS = {
    "TEXTUAL_DRIVER": "fleet_tui.ui.terminal.browser_driver:BrowserDriver",
    "TEXTUAL_COLOR_SYSTEM": "truecolor",
    "TERM": "xterm-256color",
    "COLORTERM": "truecolor",
    "PYTHONIOENCODING": "utf-8",
}
_OUR_TERMINAL = ("TMUX", "STY", "TERM_PROGRAM", "TERM_PROGRAM_VERSION", "LINES")


class Tab(AppService):
    """Like textual-serve's, but without a shell, with a guaranteed end that the page is notified of."""

    def __init__(self, command: Sequence[str], websocket: web.WebSocketResponse) -> None:
        super().__init__(
            "",
            write_bytes=websocket.send_bytes,
            write_str=websocket.send_str,
            close=self._close,
            download_manager=DownloadManager(),
        )
        self._arguments = command
        self._websocket = websocket

    async def _close(self) -> None:
        """Close the page's end, with the reason."""
        await self._websocket.close(message=b"The console has ended.")

    def _build_environment(self, width: int = 80, height: int = 24) -> dict[str, str]:
        """Return our environment, secrets included: they are in no argument. Its terminal settings don't
        apply there."""
        ours = {name: value for name, value in os.environ.items() if name not in _OUR_TERMINAL}
        return {**ours, **SETTINGS, "COLUMNS": str(width), "ROWS": str(height)}

    async def _open_app_process(self, width: int = 80, height: int = 24) -> Process:
        width, height = within(width, height)
        self._process = await asyncio.create_subprocess_exec(
            *self._arguments,
            stdin=PIPE,
            stdout=PIPE,
            stderr=PIPE,
            env=self._build_environment(width, height),
            start_new_session=True,
        )
        self._stdin = self._process.stdin
        return self._process

    async def run(self) -> None:
        """Forward the console's output. When it ends, for any reason, the page must not look live."""
        await super().run()
        with suppress(ConnectionError):
            await self._close()

    async def stop(self) -> None:
        """Stop the process, by force if needed."""
        process = self._process
        if process is None:
            return
        with suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE):
                await self.send_meta({"type": "quit"})
                await process.wait()
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # also its child processes
        if self._task is not None:
            self._task.cancel()
        with suppress(TimeoutError):
            await asyncio.wait_for(process.wait(), KILLED)

    async def on_message(self, message: object) -> None:
        """Handle a message of the page; others are ignored."""
        match message:
            case ["stdin", str(keys)]:
                await self.send_bytes(keys.encode("utf-8", "replace"))
            case ["resize", {"width": int(width), "height": int(height)}]:
                await self.set_terminal_size(*within(width, height))
            case ["ping", str(sent)]:
                await self._websocket.send_json(["pong", sent])
            case ["blur"]:
                await self.blur()
            case ["focus"]:
                await self.focus()


def within(width: int, height: int) -> tuple[int, int]:
    """Return a terminal size limited to one that can be painted."""
    return max(1, min(WIDEST, width)), max(1, min(HIGHEST, height))


class Consoles:
    """The page, its files, and their consoles."""

    def __init__(self, command: Sequence[str]) -> None:
        self._command = command
        self._places = asyncio.Semaphore(MOST_TABS)
        self._open: set[web.WebSocketResponse] = set()

    def application(self, host: str) -> web.Application:
        app = web.Application(middlewares=[guard(host)])
        files = resources.files(textual_serve) / "static"
        app.add_routes([web.get("/", _page), web.get("/ws", self._tab), web.static("/static", str(files))])
        app.on_response_prepare.append(say_policy)
        app.on_shutdown.append(self._close_all)
        return app

    async def _tab(self, request: web.Request) -> web.WebSocketResponse:
        websocket = web.WebSocketResponse(timeout=1.0, heartbeat=HEARTBEAT, max_msg_size=LONGEST_MESSAGE)
        try:
            await asyncio.wait_for(self._places.acquire(), WAIT_FOR_A_PLACE)
        except TimeoutError:
            await websocket.prepare(request)
            reason = f"{MOST_TABS} tabs open, the maximum: close one."
            await websocket.close(code=WSCloseCode.TRY_AGAIN_LATER, message=reason.encode())
            return websocket
        try:
            await websocket.prepare(request)
            self._open.add(websocket)
            await _converse(Tab(self._command, websocket), websocket, request)
        finally:
            self._open.discard(websocket)
            self._places.release()
        return websocket

    async def _close_all(self, _app: web.Application) -> None:
        reason = b"fleet-tui serve has ended."
        ends = [one.close(code=WSCloseCode.GOING_AWAY, message=reason) for one in self._open]
        await asyncio.gather(*ends, return_exceptions=True)


async def _converse(tab: Tab, websocket: web.WebSocketResponse, request: web.Request) -> None:
    try:
        await tab.start(_cells(request, "width", 80), _cells(request, "height", 24))
        async for message in websocket:
            if message.type is WSMsgType.TEXT:
                with suppress(JSONDecodeError):
                    await tab.on_message(message.json())
    finally:
        await tab.stop()


def _cells(request: web.Request, name: str, default: int) -> int:
    said = request.query.get(name, "")
    return int(said) if said.isdecimal() and len(said) < 6 else default


async def _page(_request: web.Request) -> web.Response:
    page = (resources.files("fleet_tui.features.serve") / "page.html").read_text("utf-8")
    return web.Response(text=page, content_type="text/html")


def run(command: Sequence[str], host: str, port: int, debug: bool, announce: Say, warn: Say) -> None:
    """Serve until SIGTERM; `announce` gets the URL. Raises FleetError, and SystemExit(130) on Ctrl-C."""
    log_to_file(debug)
    logging.getLogger("aiohttp").setLevel(logging.DEBUG if debug else logging.WARNING)
    if asyncio.run(_serve(command, host, port, announce, warn)):
        raise SystemExit(130)


async def _serve(command: Sequence[str], host: str, port: int, announce: Say, warn: Say) -> bool:
    """Serve until the end, and tell whether that was Ctrl-C."""
    stopped = stopped_by_signal()
    runner = web.AppRunner(Consoles(command).application(host), access_log=None, shutdown_timeout=5.0)
    await runner.setup()
    try:
        await _listen(runner, host, port)
        taken = runner.addresses[0][1]
        if not is_loopback(host):
            warn(_warning(host, taken))
        announce(f"http://{f'[{host}]' if ':' in host else host}:{taken}/")
        return await stopped
    finally:
        await runner.cleanup()


async def _listen(runner: web.AppRunner, host: str, port: int) -> None:
    try:
        await web.TCPSite(runner, host, port).start()
    except OSError as problem:
        # asyncio's own text repeats the address; an invalid name has an errno below 0.
        number = problem.errno or 0
        why = os.strerror(number) if number > 0 else problem.strerror or problem
        raise FleetError(
            Message(
                "cannot serve on {host} port {port}: {why}; use --port 0 for a free one",
                host=host,
                port=port,
                why=why,
            )
        ) from None


def _warning(host: str, port: int) -> str:
    return (
        f"warning: anyone who reaches {host} port {port} has this console: no password, no encryption.\n"
        f"Safer: omit --host, and on the other machine\n"
        f"  ssh -L {port}:127.0.0.1:{port} THIS_MACHINE    then open http://127.0.0.1:{port}/"
    )
