"""What stands around a virtual brick: the clock, connections of several carriers, faults on purpose, a page.

`host` drives the brick and serves its connections one frame after the other; `wifi` and `serial_port` carry frames to
it; `page` shows it in a browser. Everything runs in one event loop of asyncio.
"""
