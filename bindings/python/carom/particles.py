"""Sets of point masses, told apart by their place in the set."""
from __future__ import annotations

import ctypes

from . import raw
from ._values import enum, need_numpy
from .body import Thing
from .bulk import floats, place, width_of


class Particles(Thing):
    """All of it takes and gives numpy arrays (n, 3)."""

    __slots__ = ()
    _destroy = staticmethod(raw.carom_particles_destroy)

    def __len__(self) -> int:
        return self._get(raw.carom_particles_get_count, ctypes.c_uint64)

    def add(self, positions, velocities=None) -> None:
        """m, m/s; without velocities they are at rest."""
        positions = floats(positions)
        address, n, scalar, stride, held = place(positions, 3, None, False)
        fast, fast_stride, held_too = None, 0, None
        if velocities is not None:
            fast, _, _, fast_stride, held_too = place(floats(velocities).astype(positions.dtype), 3, n, False)
        self._call(raw.carom_particles_add, n, scalar, address, stride, fast, fast_stride)

    def remove(self, indices) -> None:
        """The others keep their order."""
        chosen = (ctypes.c_uint32 * len(indices))(*indices)
        self._call(raw.carom_particles_remove, chosen, len(chosen))

    def read(self, field: str | int = "position", out=None, dtype="float64"):
        """ "position", "linear_velocity" or "mass" of all of them."""
        np = need_numpy("Particles.read()")
        field = enum("FIELD", field)
        n, width = len(self), width_of(field)
        out = np.empty((n, width), dtype) if out is None else out
        address, _, scalar, stride, held = place(out, width, n, True)
        self._call(raw.carom_particles_read, field, scalar, None, n, address, stride)
        return out

    def write(self, field: str | int, values) -> None:
        field = enum("FIELD", field)
        values = floats(values)
        address, n, scalar, stride, held = place(values, width_of(field), len(self), False)
        self._call(raw.carom_particles_write, field, scalar, None, n, address, stride)
