"""The version, where the build finds it without importing the rest."""

VERSION = "0.2.0"

REPOSITORY = ""
"""The address of the repository, which `bin/addresses` writes into a release; empty if it is unknown."""

REPORT_IT = f"please report it at {REPOSITORY}/issues" if REPOSITORY else "please report it"
"""A request in messages about bugs in ev3proto."""
