"""The command as a process: its output streams, and being told to end."""

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Terminated(KeyboardInterrupt):
    """SIGTERM: ends the command as Ctrl-C does, with a status of its own."""

    exit_status = 128 + signal.SIGTERM


_HANDLERS = {signal.SIGINT: signal.default_int_handler, signal.SIGTERM: signal.SIG_DFL}
_received: list[int] = []


@contextmanager
def interruptible() -> Iterator[None]:
    """Inside, SIGTERM raises Terminated and SIGINT KeyboardInterrupt; only the main thread can have that.

    A signal that somebody else handles or ignores is left to them.
    """
    ours = {}
    if threading.current_thread() is threading.main_thread():
        ours = {number: usual for number, usual in _HANDLERS.items() if signal.getsignal(number) is usual}
    for number in ours:
        signal.signal(number, _interrupt)
    try:
        yield
    finally:
        for number, usual in ours.items():
            signal.signal(number, usual)
        _received.clear()


def check_interrupted() -> None:
    """Raise an interruption anew: one that came during an import or a callback may have been swallowed there."""
    if _received:
        _interrupt(_received[-1], None)


def tolerate_any_text() -> None:
    """Let output that cannot show a sign, such as µ, show another instead of failing."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")


def discard_output() -> None:
    """Point standard output nowhere, so that Python's own flush at the end does not fail once more."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)


def _interrupt(number: int, frame: object) -> None:
    _received.append(number)
    raise Terminated if number == signal.SIGTERM else KeyboardInterrupt
