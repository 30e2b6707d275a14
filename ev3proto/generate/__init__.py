"""Other tools' forms of the tables: what the command line writes for Wireshark. Reads tables, not frames."""
