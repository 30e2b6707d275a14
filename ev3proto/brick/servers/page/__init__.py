"""The page that shows a virtual brick in a browser: its messages are in `state`, the server in `server`."""
