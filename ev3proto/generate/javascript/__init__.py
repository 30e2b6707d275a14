"""JavaScript: `build` joins ev3.mjs, which makes frames, and `decoder` ev3-decode.mjs, which reads them.

`.mjs` and `.d.ts` files here are written by hand; `tables` and `typescript` write the rest from tables and schemas.
"""
