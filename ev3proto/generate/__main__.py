"""`python -m ev3proto.generate`: starts `ev3proto.cli.generate`, which has the command line that a page is about."""

import runpy

runpy.run_module("ev3proto.cli.generate", run_name="__main__")
