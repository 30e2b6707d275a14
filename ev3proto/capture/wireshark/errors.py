"""What goes wrong with the engine itself."""

from ev3proto.capture.errors import CaptureError


class EngineError(CaptureError):
    """Why tshark cannot be used, and what to do, in a sentence."""
