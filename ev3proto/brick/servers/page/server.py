"""Serves the page. Only who has the link, with the token in it, gets anything; pages of other sites get nothing.

The token is made anew at each start. The page turns it into a cookie that scripts cannot read. Names and texts go to
the page as JSON, and it shows them as text.
"""

from __future__ import annotations

import asyncio
import hmac
import ipaddress
import json
import logging
import secrets
import time
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from importlib.resources import files

from aiohttp import WSMsgType, web
from aiohttp.http import HttpProcessingError

from ev3proto.brick.servers.host import Host
from ev3proto.brick.servers.page.state import Changes, answer
from ev3proto.brick.servers.page.watcher import Watcher

PERIOD = 0.05
"""Seconds from one look at the brick to the next."""

MOST_PAGES = 16
"""Pages at once."""

_MOST_MESSAGE = 1 << 14
_STATIC = {
    "/": ("page.html", "text/html"),
    "/page.js": ("page.js", "text/javascript"),
    "/brick.js": ("brick.js", "text/javascript"),
    "/brick.css": ("brick.css", "text/css"),
    "/icon.svg": ("icon.svg", "image/svg+xml"),
}
_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class PageError(Exception):
    """The page cannot be served; the text says why and what to do."""


@asynccontextmanager
async def serving(host: Host, address: str, port: int) -> AsyncIterator[tuple[str, asyncio.Event]]:
    """Serves the page for as long as the context lasts.

    Args:
        host: What drives the brick.
        address: Of this computer.
        port: 0 for any that is free.

    Yields:
        The link that opens it, and an event that is set when somebody has.

    Raises:
        PageError: The port cannot be opened.
    """
    page = _Page(host)

    async def guard(request: web.Request, handler: Handler) -> web.StreamResponse:
        return await page.guard(request, handler)

    application = web.Application(middlewares=[web.middleware(guard)])
    for path in _STATIC:
        application.router.add_get(path, page.static)
    application.router.add_get("/live", page.live)
    logger = logging.Logger(__name__)
    logger.addHandler(_Log(host))
    runner = web.AppRunner(application, access_log=None, logger=logger, handle_signals=False, shutdown_timeout=0.2)
    await runner.setup()
    try:
        try:
            await web.TCPSite(runner, address, port).start()
        except OSError as error:
            raise PageError(
                f"port {port} of {address} cannot be opened for the page: {error.strerror or error}; --http alone takes"
                " any that is free"
            ) from None
        page.port = runner.addresses[0][1]
        host.observers.append(page.watcher)
        shown = f"[{address}]" if ":" in address else address
        yield f"http://{shown}:{page.port}/?token={page.token}", page.was_opened
    finally:
        await page.close()
        await runner.cleanup()


class _Log(logging.Handler):
    """What the server library logs, as a sentence of the brick."""

    def __init__(self, host: Host) -> None:
        super().__init__(logging.WARNING)
        self._host = host

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        if isinstance(error, HttpProcessingError):
            self._host.say_once("a request to the page was not HTTP, and was refused")
        else:
            self._host.say_once(f"a defect of the page, please report it: {error or record.getMessage()!r}")


class _Page:
    """What answers the browser."""

    def __init__(self, host: Host) -> None:
        self.port = 0
        self.token = secrets.token_urlsafe(24)
        begin = time.perf_counter()
        self.watcher = Watcher(lambda: time.perf_counter() - begin)
        self.was_opened = asyncio.Event()
        self._host = host
        self._sockets: set[web.WebSocketResponse] = set()

    async def close(self) -> None:
        """Ends all pages."""
        for socket in list(self._sockets):
            with suppress(OSError, TimeoutError):
                await asyncio.wait_for(socket.close(), 1)

    # Who may come in

    async def guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        """Lets nobody in who was not given the link, nor a page of another site that sends its visitors here."""
        reason = self._refusal(request)
        if reason is not None:
            response: web.StreamResponse = web.Response(status=403, text=f"{reason}\n")
        else:
            try:
                response = await handler(request)
            except web.HTTPException as error:
                response = web.Response(status=error.status, text=f"{error.reason}\n")
        if not response.prepared:
            response.headers.update(_HEADERS)
            response.headers["Content-Security-Policy"] = self._policy(request.host if reason is None else "")
            if reason is None and "token" in request.query:
                response.set_cookie(self._cookie, self.token, httponly=True, samesite="Strict", path="/")
        return response

    def _refusal(self, request: web.Request) -> str | None:
        """Why a request is refused."""
        if not self._is_own_host(request.host):
            return "this page is reached by its address only, not by another name"
        origin = request.headers.get("Origin")
        if origin is not None and origin != f"http://{request.host}":
            return "another site's page may not come here"
        given = request.query.get("token") or request.cookies.get(self._cookie, "")
        if not hmac.compare_digest(given.encode(errors="replace"), self.token.encode()):
            return "open the link that ev3proto printed: it has a token, which is another one at each start"
        return None

    def _is_own_host(self, host: str) -> bool:
        """Whether a Host header names this computer by number: a name could be one that others let lead here."""
        name, _, port = host.rpartition(":")
        if port != str(self.port):
            return False
        if name == "localhost":
            return True
        try:
            ipaddress.ip_address(name.removeprefix("[").removesuffix("]"))
        except ValueError:
            return False
        return True

    @property
    def _cookie(self) -> str:
        # A browser keeps cookies by host, whatever the port.
        return f"ev3proto-{self.port}"

    @staticmethod
    def _policy(host: str) -> str:
        live = f" ws://{host}" if host else ""
        return (
            f"default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'{live};"
            " base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
        )

    # What there is

    async def static(self, request: web.Request) -> web.StreamResponse:
        """The page itself."""
        name, kind = _STATIC[request.path]
        body = (files("ev3proto.brick.servers.page") / "static" / name).read_bytes()
        return web.Response(body=body, content_type=kind, charset="utf-8")

    async def live(self, request: web.Request) -> web.StreamResponse:
        """All that happens, as it happens, and what is asked for."""
        if len(self._sockets) >= MOST_PAGES:
            return web.Response(status=503, text=f"there are {MOST_PAGES} pages already\n")
        socket = web.WebSocketResponse(max_msg_size=_MOST_MESSAGE, heartbeat=20)
        await socket.prepare(request)
        self._sockets.add(socket)
        self.was_opened.set()
        sender = asyncio.create_task(self._send(socket))
        try:
            async for message in socket:
                if message.type is not WSMsgType.TEXT:
                    continue
                said = answer(self._host.brick, message.data)
                self._host.wake()
                if said is not None:
                    await socket.send_str(json.dumps(said))
        except ConnectionError:
            pass  # the browser has gone
        finally:
            sender.cancel()
            self._sockets.discard(socket)
        return socket

    async def _send(self, socket: web.WebSocketResponse) -> None:
        """Sends what has changed. A page that does not read is sent nothing more until it does."""
        unshown = self.watcher.open()
        changes = Changes(self._host.brick, unshown, lambda: [each.name for each in self._host.connections])
        try:
            while True:
                new = changes.take()
                if new:
                    await socket.send_str(json.dumps(new))
                await asyncio.sleep(PERIOD)
        except ConnectionError:
            pass  # the browser has gone
        finally:
            self.watcher.close(unshown)
