"""Captures from frames: pcapng files with a conversation between a computer and a brick over any carrier.

    with open("tones.pcapng", "wb") as stream:
        write_pcapng(messages, stream, carrier="bluetooth")

`carrier_writer` says which frames can be carried and in which direction; `wifi`, `usb` and `bluetooth` wrap frames in
the packets of their carrier; `packets` gives each packet its time and writes the file.
"""

from ev3proto.generate.captures.carrier_writer import TimedFrame
from ev3proto.generate.captures.packets import CaptureWriter, PacketFile, carrier_writer, write_pcapng

__all__ = ["CaptureWriter", "PacketFile", "TimedFrame", "carrier_writer", "write_pcapng"]
