"""The rules of the checker, one topic a file. Every rule takes a context and yields findings.

Rules do not repeat each other: one cause, one finding.
"""
