"""WiFi: internet packets, TCP streams put in order, and the connections and datagrams of bricks in them."""

from ev3proto.capture.carriers.wifi.connections import Connections as Reader

__all__ = ["Reader"]
