"""The protocol in other tools' forms: dissector, headers, descriptions, and captures made from frames."""
