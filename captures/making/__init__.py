"""What `make.py` makes the captures from: the two ends' frames, the carriers around them, and the files."""
