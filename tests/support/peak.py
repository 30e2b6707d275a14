"""The memory of a subcommand: a process of its own runs it and prints the maximum last."""

from __future__ import annotations

PEAK = """
import sys
from ev3proto.cli.main import main
sys.argv[0] = "ev3proto"
try:
    main()
finally:
    with open("/proc/self/status") as status:
        print(next(line.split()[1] for line in status if line.startswith("VmHWM")), file=sys.stderr)
"""
"""Runs a subcommand, and prints last the maximum of its memory in KiB."""
