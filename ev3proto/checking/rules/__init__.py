"""What a careful sender fixes, a topic a file. Every rule takes a context and gives findings.

A rule does not give what another one has found: one cause, one finding.
"""
