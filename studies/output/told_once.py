"""Warnings on the terminal: each once, however many runs of a study make it."""

import logging
import sys


class ToldOnce(logging.Handler):
    """Prints a message on standard error unless it has been printed before."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self._told: set[str] = set()

    def emit(self, record: logging.LogRecord) -> None:
        """Print a record's message if it is new."""
        message = record.getMessage()
        if message not in self._told:
            self._told.add(message)
            print(message, file=sys.stderr, flush=True)


def tell_warnings_once() -> None:
    """Let this process tell each warning once; a program that has handlers of its own keeps them."""
    root = logging.getLogger()
    if not root.handlers:
        root.addHandler(ToldOnce())
