"""Messages as JSON and back: `from_messages` makes the records of `decode --json`, `to_messages` reads them."""
