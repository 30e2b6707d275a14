"""Limits for one client, so that it can neither stop the others nor fill this computer's memory."""

STRETCH = 0.02
"""Seconds of the processor after which a direct command pauses, so that everything else can run."""

PATIENCE = 10.0
"""Seconds after which a direct command is ended when another client waits for it."""

MOST_BUFFERED = 1 << 17
"""Bytes of a client that the brick has not read yet; at this limit reading pauses. One frame fits."""

MOST_UNREAD = 1 << 16
"""Bytes of replies that a client leaves unread before its next frame waits."""

MOST_DELAYED = 64
"""Replies to one client that are held back by `--delay` before its next frame waits."""

MOST_QUEUED = 64
"""Connections that may wait until a client disconnects; further ones are closed at once."""

MOST_PAGE_CONNECTIONS = 64
"""Connections to the page; beyond that the oldest without an open page is closed."""

UNLOCK_TIME = 30.0
"""Seconds in which a client has to send the unlock text."""
