"""The playground: a page that reads frames and runs a virtual brick, without anything installed.

npm fetches Pyodide (Python for browsers) and Vega by package-lock.json. `packing` packs what Python imports;
make_snapshot.mjs starts it once in node and keeps a snapshot of its memory, from which boot.js starts in the browser,
or without it; loads.js counts what comes, and missing.js says what of the page does not. esbuild joins the scripts to
playground.js and worker.js. service-worker.js keeps the files that `build` names. first.js shows a frame in hex before
Python is there.

state.js has what the page knows, from which its texts follow; each other script has one concern. The brick is shown
by ev3proto/brick/servers/page/static/brick.js, as on the page of `brick --http`. The worker runs Python, the
package `bridge`: `reading` and `findings` read an input once, step by step; `pages` makes lines of its frames when
their page is opened; `headline` words what comes first, and `proposals` finds what was meant. `real_brick` is the
session with a real brick, on a `connection` whose bytes carriers.js moves.

The scripts are linted, and their types in JSDoc checked. tests/browsers tries the page in Firefox and WebKit, too.
"""
