"""The command line: one module a subcommand, which turns arguments into calls of the layers below."""
