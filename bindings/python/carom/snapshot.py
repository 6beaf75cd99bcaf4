"""A world as bytes, and back; a copy of it; a session as bytes (carom/snapshot.h, carom/record.h)."""
from __future__ import annotations

import ctypes
from types import TracebackType
from typing import TYPE_CHECKING, Any, BinaryIO, Callable, NamedTuple, TypeVar, cast

from . import raw

if TYPE_CHECKING:
    from .body import Thing
    from .world import World

T = TypeVar("T", bound="Thing")


class Difference(NamedTuple):
    """What of a world is not as a snapshot says: sections, most telling first; what differs first (a Body, a Joint, ...; of
    a pair of colliders both), or None."""
    sections: tuple[str, ...]
    first: object
    second: object


class _Sink:
    """What the library writes to. Knows nothing of the world, which it lives as long as."""

    def __init__(self, file: BinaryIO):
        self.file = file
        self.error: BaseException | None = None

    def take(self, user: int | None, data: int, size: int) -> int:
        try:
            self.file.write(ctypes.string_at(data, size))
            return 0
        except BaseException as why:  # noqa: BLE001  it cannot pass through the library; end() raises it
            self.error = why
            return 1


class Recording:
    """What World.record() began. Ends with end(), with its `with`, or with the world."""

    def __init__(self, world: World, file: BinaryIO, states: bool):
        self._world, self._sink, self._open = world, _Sink(file), False
        self._write = raw.carom_write_fn(self._sink.take)
        world._owner.alive.append(self._write)  # the library may call it until the world is gone
        flags = raw.CAROM_RECORD_STATES if states else raw.CAROM_RECORD_HASHES
        try:
            world._call(raw.carom_world_record_begin, flags, self._write, None)
        except BaseException as why:
            world._owner.alive.remove(self._write)
            raise why from self._sink.error
        self._open = True

    def end(self) -> None:
        """Raises WriteFailed, from what the file raised, if not all was written."""
        if not self._open:
            return
        self._open = False
        try:
            self._world._call(raw.carom_world_record_end)
        except BaseException as why:
            raise why from self._sink.error
        finally:
            if self._write in self._world._owner.alive:
                self._world._owner.alive.remove(self._write)

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None) -> None:
        self.end()


class Snapshots:
    """Of a world."""

    _call: Callable[..., None]
    _wrap: Callable[[str, int], Any]
    _adopted: Callable[..., Any]
    engine: Any

    def save(self, whole: bool = False) -> bytes:
        """The state; `whole`: with all that it takes to make the world again in another process."""
        flags, size = raw.CAROM_SNAPSHOT_WHOLE if whole else raw.CAROM_SNAPSHOT_STATE, ctypes.c_uint64()
        self._call(raw.carom_world_save, flags, None, 0, ctypes.byref(size))
        buffer = ctypes.create_string_buffer(size.value)
        self._call(raw.carom_world_save, flags, buffer, size.value, ctypes.byref(size))
        return buffer.raw

    def restore(self, data: bytes) -> None:
        """Go on from what save() gave: of this world, of one made by the same calls, or whole into a world in which nothing
        was made yet (the shapes' plugins must be loaded)."""
        self._call(raw.carom_world_restore, bytes(data), len(data))

    def fork(self) -> World:
        """A world of the same engine that goes on as this one does, bit for bit. `copy.counterpart(body)` is the body there."""
        pointer = ctypes.c_void_p()
        self._call(raw.carom_world_fork, ctypes.byref(pointer))
        return cast("World", self._adopted(self.engine, pointer.value))

    def counterpart(self, other: T) -> T:
        """The object of this world that `other`, a Body, Joint, ... of a world that this one was forked or restored from, is
        there."""
        handle = ctypes.c_uint64(other.handle)
        self._call(raw.carom_world_translate_handles, ctypes.byref(handle), 1, ctypes.byref(handle))
        return type(other)(cast("World", self), handle.value)

    def compare(self, data: bytes) -> Difference | None:
        """None: the state is what save() gave, to the bit."""
        out = raw.carom_difference()
        out.struct_size = ctypes.sizeof(out)
        self._call(raw.carom_world_compare, bytes(data), len(data), ctypes.byref(out))
        if not out.differs:
            return None

        def name(handle: int) -> object:
            return self._wrap(_KINDS[handle >> 60], handle) if handle else None

        return Difference(tuple(out.sections.decode().split(", ")), name(out.first), name(out.second))

    def record(self, file: BinaryIO, states: bool = False) -> Recording:
        """Write every call from now on, and the hash of each step, to a file opened for binary writing: for `carom replay`.
            with open("session.rec", "wb") as file, world.record(file): ...
        @param states  the state after each step, too, so that a replay can name the body that differs"""
        return Recording(cast("World", self), file, states)


_KINDS = {3: "carom_material", 4: "carom_body", 5: "carom_collider", 6: "carom_particles", 7: "carom_joint",
          8: "carom_force_field", 9: "carom_spring"}
