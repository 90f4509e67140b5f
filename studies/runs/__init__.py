"""One run of a scene: its loop, when it ends, what comes of it and what it costs."""
