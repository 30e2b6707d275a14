"""The tables as JSON, for programs in any language, and the JSON Schema that says what stands in it.

`data` turns the tables into plain values, `schema` describes those, `writing` puts them into lines that people can
read, `build` makes the two files.
"""
