"""What the tests share and is no test itself: captures built by hand, drawn frames, tshark, the command line."""
