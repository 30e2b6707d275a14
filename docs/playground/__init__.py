"""The playground: a page that reads frames and runs a virtual brick, without anything installed."""
