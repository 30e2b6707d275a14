"""Serves the built documentation to browsers on this computer, and prints the link of the playground."""

from __future__ import annotations

import contextlib
import functools
import sys
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

PORTS = (*range(8000, 8010), 0)
"""The first free one is used; 0 is any. A browser keeps what it stored of the playground by port."""


class Handler(SimpleHTTPRequestHandler):
    """Files without a line on the terminal for each."""

    def log_message(self, format: str, *args: object) -> None:
        """Prints nothing."""


def open_server(folder: Path) -> ThreadingHTTPServer:
    """Returns a server of a folder's files on 127.0.0.1, at the first free port."""
    handler = functools.partial(Handler, directory=str(folder))
    for port in PORTS[:-1]:
        try:
            return ThreadingHTTPServer(("127.0.0.1", port), handler)
        except OSError:  # another program has this port
            continue
    return ThreadingHTTPServer(("127.0.0.1", PORTS[-1]), handler)


def main(folder: Path) -> None:
    """Serves a folder until it is interrupted."""
    with open_server(folder) as server:
        print(f"http://127.0.0.1:{server.server_port}/playground/", flush=True)
        print("Open this link in a browser; Ctrl-C ends the server.", file=sys.stderr)
        with contextlib.suppress(KeyboardInterrupt):
            server.serve_forever()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
