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


AGAIN, SOON = 10.0, 0.05  # s
_HANDLERS = {
    signal.SIGINT: signal.default_int_handler,
    signal.SIGTERM: signal.SIG_DFL,
    signal.SIGALRM: signal.SIG_DFL,
}
_received: list[int] = []


@contextmanager
def interruptible() -> Iterator[None]:
    """Inside, SIGTERM raises Terminated and SIGINT KeyboardInterrupt; only the main thread can have that.

    Both are raised again as long as that does not end the block: code in between may swallow them, as the compiler's
    callbacks do. A signal that somebody else handles or ignores is left to them.
    """
    ours = {}
    if threading.current_thread() is threading.main_thread():
        ours = {number: usual for number, usual in _HANDLERS.items() if signal.getsignal(number) is usual}
    for number in ours:
        signal.signal(number, _interrupt)
    try:
        with _swallowed_are_told():
            yield
    finally:
        _raise_again_in(0.0)
        for number, usual in ours.items():
            signal.signal(number, usual)
        _received.clear()


@contextmanager
def _swallowed_are_told() -> Iterator[None]:
    """Let an interruption that nobody could raise, in a callback of C code, come again in place of its traceback."""
    before = sys.unraisablehook

    def told(unraisable) -> None:
        if isinstance(unraisable.exc_value, KeyboardInterrupt):
            _raise_again_in(SOON)
        else:
            before(unraisable)

    sys.unraisablehook = told
    try:
        yield
    finally:
        sys.unraisablehook = before


def check_interrupted() -> None:
    """Raise an interruption anew, at once: one that came during an import may have been swallowed there."""
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
    if number != signal.SIGALRM or not _received:
        _received.append(number)
    _raise_again_in(AGAIN)
    raise Terminated if _received[-1] == signal.SIGTERM else KeyboardInterrupt


def _raise_again_in(seconds: float) -> None:
    """By the alarm clock, if it is ours; 0 stops it."""
    if signal.getsignal(signal.SIGALRM) is _interrupt:
        signal.setitimer(signal.ITIMER_REAL, seconds)
