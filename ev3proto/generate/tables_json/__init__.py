"""The tables as JSON, for programs in any language, and the JSON Schema that describes it.

`data` turns the tables into plain values, `schema` describes those, `json_text` lays them out in lines that people can
read, `build` makes the two files.
"""
