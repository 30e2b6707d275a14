"""Messages as JSON and back: `writing` makes the records of `decode --json`, `reading` makes messages of them again."""
