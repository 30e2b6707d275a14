"""The server of the page. It answers only to the link, which contains a token, and never to pages of other sites.

Each start makes a new token. The page turns it into a cookie that scripts cannot read. Names and texts go to
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
from functools import partial
from importlib.resources import files

from aiohttp import WSMsgType, web
from aiohttp.http import HttpProcessingError

from ev3proto.brick.limits import MOST_PAGE_CONNECTIONS
from ev3proto.brick.servers.host import Host, ServerError
from ev3proto.brick.servers.listening import listen
from ev3proto.brick.servers.page.state import Changes, answer
from ev3proto.brick.servers.page.watcher import Watcher
from ev3proto.version import REPORT_IT

PERIOD = 0.05
"""Seconds between updates of the pages."""

MOST_PAGES = 16
"""Maximum number of open pages."""

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


@asynccontextmanager
async def serving(host: Host, address: str, port: int) -> AsyncIterator[tuple[str, asyncio.Event]]:
    """Yields the page's link, and an event that is set once a browser has opened it. Raises ServerError."""
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
        assert runner.server is not None
        try:
            page.servers = await listen(partial(page.connected, runner.server), address, port)
        except (OSError, OverflowError, UnicodeError) as error:
            raise ServerError(
                f"port {port} of {address} cannot be opened for the page: {getattr(error, 'strerror', None) or error};"
                " --http alone takes any that is free"
            ) from None
        page.port = page.servers[0].sockets[0].getsockname()[1]
        host.observers.append(page.watcher)
        shown = f"[{address}]" if ":" in address else address
        yield f"http://{shown}:{page.port}/?token={page.token}", page.was_opened
    finally:
        await page.close()
        await runner.cleanup()


class _Log(logging.Handler):
    """Reports messages of the server library as messages of the brick."""

    def __init__(self, host: Host) -> None:
        super().__init__(logging.WARNING)
        self._host = host

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        if isinstance(error, HttpProcessingError):
            self._host.say_once("a request to the page was not HTTP, and was refused")
        else:
            self._host.say_once(f"the page has a bug, {REPORT_IT}: {error or record.getMessage()!r}")


class _Page:
    """The handlers of the browser's requests."""

    def __init__(self, host: Host) -> None:
        self.port = 0
        self.servers: list[asyncio.Server] = []
        self.token = secrets.token_urlsafe(24)
        begin = time.perf_counter()
        self.watcher = Watcher(lambda: time.perf_counter() - begin)
        self.was_opened = asyncio.Event()
        self._host = host
        self._sockets: set[web.WebSocketResponse] = set()
        self._shown: set[asyncio.BaseProtocol] = set()

    # Connections

    def connected(self, server: web.Server) -> asyncio.BaseProtocol:
        """Takes a connection; beyond the limit, the oldest without an open page are closed."""
        asyncio.get_running_loop().call_later(PERIOD, self._limit, server)
        return server()

    def _limit(self, server: web.Server) -> None:
        silent = [each for each in server.connections if each not in self._shown]
        for oldest in silent[: max(0, len(server.connections) - MOST_PAGE_CONNECTIONS)]:
            if oldest.transport is not None:
                oldest.transport.abort()

    async def close(self) -> None:
        """Closes the port and all pages."""
        for server in self.servers:
            server.close()
        for socket in list(self._sockets):
            with suppress(OSError, TimeoutError):
                await asyncio.wait_for(socket.close(), 1)

    # Access

    async def guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        """Refuses requests without the token of the link, and requests that a page of another site makes."""
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
        """Returns why a request is refused; None if it is allowed."""
        if not self._is_own_host(request.host):
            return "open this page by localhost or its IP address, not by another name"
        origin = request.headers.get("Origin")
        if origin is not None and origin != f"http://{request.host}":
            return "pages of other sites have no access"
        given = request.query.get("token") or request.cookies.get(self._cookie, "")
        if not hmac.compare_digest(given.encode(errors="replace"), self.token.encode()):
            return "open the link that ev3proto printed: it contains a token, which changes at each start"
        return None

    def _is_own_host(self, host: str) -> bool:
        """Returns whether a Host header is an IP address or localhost: DNS rebinding needs another name."""
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

    # Contents

    async def static(self, request: web.Request) -> web.StreamResponse:
        """Answers with the page itself."""
        name, kind = _STATIC[request.path]
        body = (files("ev3proto.brick.servers.page") / "static" / name).read_bytes()
        return web.Response(body=body, content_type=kind, charset="utf-8")

    async def live(self, request: web.Request) -> web.StreamResponse:
        """Sends updates over a WebSocket, and runs the actions of the page."""
        if len(self._sockets) >= MOST_PAGES:
            return web.Response(status=503, text=f"too many open pages: at most {MOST_PAGES}\n")
        socket = web.WebSocketResponse(max_msg_size=_MOST_MESSAGE, heartbeat=20)
        await socket.prepare(request)
        self._sockets.add(socket)
        self._shown.add(request.protocol)
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
            self._shown.discard(request.protocol)
        return socket

    async def _send(self, socket: web.WebSocketResponse) -> None:
        """Sends the changes, and waits for a page that does not read."""
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
