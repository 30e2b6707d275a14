"""The servers of a virtual brick: its clock, connections of several carriers, deliberate faults, the page.

`host` drives the brick and serves its connections one frame after the other; `wifi` and `serial_port` carry frames to
it; `page` shows it in a browser. Everything runs in one event loop of asyncio.
"""
