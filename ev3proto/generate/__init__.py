"""Other tools' forms: the dissector, headers and descriptions drawn from the tables, and captures made of frames."""
