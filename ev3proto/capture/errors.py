"""What goes wrong with a capture as a whole, said in a sentence."""


class CaptureError(ValueError):
    """A file that is no capture, or one that is damaged, of which everything readable was given before."""
