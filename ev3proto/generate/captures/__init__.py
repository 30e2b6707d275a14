"""Captures out of frames: pcapng files with a conversation of a computer and a brick on any carrier.

    with open("tones.pcapng", "wb") as stream:
        write_pcapng(messages, stream, carrier="bluetooth")

`carrier_writer` says which frames can be carried and which way they go; `wifi`, `usb` and `bluetooth` put around them
what stands around frames on the carrier; `writing` gives each packet its time and writes the file.
"""

from ev3proto.generate.captures.carrier_writer import TimedFrame
from ev3proto.generate.captures.packets import CaptureWriter, PacketFile, carrier_writer, write_pcapng

__all__ = ["CaptureWriter", "PacketFile", "TimedFrame", "carrier_writer", "write_pcapng"]
