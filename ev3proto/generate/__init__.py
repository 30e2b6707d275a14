"""The protocol in the formats of other tools: dissector, headers, descriptions, and captures made from frames."""
