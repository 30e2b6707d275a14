"""The sources of the captures that `make.py` writes: the frames of both ends, the carriers, and the file formats."""
