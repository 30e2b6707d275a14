"""The meaning of operations' arguments, derived from the tables in one place.

`footprint` tells which bytes of memory an operation uses, `inline_arrays` which texts and arrays it contains, `domain`
the legal values of a parameter and their description, `replies` what a reply carries, `pairing` which command it
answers, `transfers` which file a system message belongs to. Composing, checking, dialogues, texts and exports use these
functions.
"""
