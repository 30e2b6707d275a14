"""`python -m ev3proto`: the command line without a script on the path."""

from ev3proto.cli.main import main

main()
