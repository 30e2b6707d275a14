"""The page that shows a virtual brick in a browser: what it sends is in `state`, the server in `server`."""
