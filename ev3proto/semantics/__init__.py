"""What the arguments of operations mean, worked out from the tables once for everybody who needs it.

`footprint` tells which bytes of memory an operation uses, `inline_arrays` which texts and arrays stand in it, `domain`
which values of a parameter are legal and how to say so, `replies` what a reply carries, `pairing` which command it
answers, `transfers` which file a system message is about. Composing, checking, dialogues, texts and exports ask here
and keep no copy.
"""
