"""The surroundings of a virtual brick: the clock, connections of several carriers, deliberate faults, a page.

`host` drives the brick and serves its connections one frame after the other; `wifi` and `serial_port` carry frames to
it; `page` shows it in a browser. Everything runs in one event loop of asyncio.
"""
