"""The meaning of operations' arguments, derived from the tables in one place.

`facts` has what follows from the declaration of an operation and of its parameters, `domain` the legal values of a
parameter and their description, `footprint` the bytes of memory that an operation uses and the texts and arrays in it,
`replies` what a reply carries. Composing, checking, dialogues, texts and exports use them.
"""
