"""Packets that tshark or pyshark has taken apart, as events. `ev3proto.pyshark` runs tshark."""
