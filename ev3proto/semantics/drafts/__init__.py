"""Drafts of operations: values checked and encoded, variables that may still be without a place in memory."""
