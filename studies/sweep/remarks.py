"""What a job says by way of warnings: kept with its result, for many jobs may say the same."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager

OURS = ("core_models", "fem", "mpm", "meshes", "studies")


class _Listener(logging.Handler):
    """Keeps every warning of ours once; a worker's own are none of the job's."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.said: dict[str, None] = {}

    def emit(self, record: logging.LogRecord) -> None:
        if record.name.partition(".")[0] in OURS:
            self.said[record.getMessage()] = None


@contextmanager
def remarks() -> Iterator[dict[str, None]]:
    """Warnings that are logged meanwhile, as keys; with a handler of its own the process prints none of them."""
    listener = _Listener()
    root = logging.getLogger()
    root.addHandler(listener)
    try:
        yield listener.said
    finally:
        root.removeHandler(listener)
