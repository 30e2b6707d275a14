"""The command line: one module a subcommand, each no more than the way from the words typed to the functions called."""
