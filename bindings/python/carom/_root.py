"""What engines and worlds have in common: a pointer that is closed once, calls that cannot outlive it."""
from __future__ import annotations

import ctypes
import threading
import weakref
from collections import deque
from types import TracebackType
from typing import TYPE_CHECKING, Any, Callable

from . import raw
from .errors import Busy, Closed, raise_for

if TYPE_CHECKING:
    from typing_extensions import Self


class _Scratch(threading.local):
    """A carom_error for each thread, used again and again: the library writes it on failure only."""

    def __init__(self) -> None:
        self.error = raw.carom_error()
        self.error.struct_size = ctypes.sizeof(raw.carom_error)
        self.reference = ctypes.byref(self.error)


_scratch = _Scratch()


def check(function: Callable[..., int], *arguments: object) -> None:
    """Call a function whose last argument is a carom_error*; raise what it says."""
    scratch = _scratch
    result = function(*arguments, scratch.reference)
    if result:
        raise_for(result, scratch.error)


class Owner:
    """Holds the pointer, and all that must live as long as it does. Destroyed when nothing refers to it any more, so a
    world's owner, which refers to its engine's, always goes first, in whatever order Python collects the two."""

    def __init__(self, pointer: int | None, destroy: Callable[..., int], *alive: object):
        self.alive: list[Any] = list(alive)
        self.finalizer = weakref.finalize(self, Owner._destroy, destroy, pointer, self.alive)

    @staticmethod
    def _destroy(destroy: Callable[..., int], pointer: int | None, alive: list[Any]) -> None:
        destroy(pointer, None)
        alive.clear()


def count_of(n: int, what: str) -> str:
    """3 bodies, 1 body"""
    return f"{n} {what if n == 1 else what[:-1] + 'ies' if what.endswith('y') else what + 's'}"


class Root:
    """A closed root raises Closed; one that is used on another thread just now is not closed but raises Busy."""

    _kind = "root"

    def __init__(self, pointer: int | None, destroy: Callable[..., int], *alive: object):
        self._pointer = pointer
        self._destroy = destroy
        self._owner = Owner(pointer, destroy, *alive)
        self._calls: deque[None] = deque()  # one entry a call in progress: append and pop are atomic, and cheaper than a lock
        self._closed = False

    def _call(self, function: Callable[..., int], *arguments: object) -> None:
        """function(pointer, *arguments, error), unless closed."""
        self._calls.append(None)
        try:
            if self._closed:
                raise Closed(f"this {self._kind} was closed", "make another one, or close it later")
            scratch = _scratch
            result = function(self._pointer, *arguments, scratch.reference)
        finally:
            self._calls.pop()
        if result:
            raise_for(result, scratch.error)

    @property
    def closed(self) -> bool:
        return self._closed

    def close(self) -> None:
        """Give back all memory at once; what belonged to it raises Closed from now on. Closing twice does nothing."""
        if self._closed:
            return
        self._closed = True
        if self._calls:
            self._closed = False
            raise Busy(f"this {self._kind} is used on another thread, or by the call that called back", "wait until that call has returned")
        try:
            check(self._destroy, self._pointer)
        except BaseException:
            self._closed = False
            raise
        self._owner.finalizer.detach()
        self._owner.alive.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
