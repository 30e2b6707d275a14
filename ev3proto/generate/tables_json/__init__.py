"""The tables as JSON, for programs in any language, and the JSON Schema that describes it.

`build` has each property once, with its schema and its value; `shapes` makes objects and schemas of properties;
`json_text` lays them out in lines that people can read.
"""
