"""Drafts of operations: checked and encoded values, and variables that may not have a place in memory yet."""
