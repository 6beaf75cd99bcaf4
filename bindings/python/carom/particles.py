"""Sets of point masses, told apart by their place in the set."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Literal, Sequence, TypeVar, overload

from . import raw
from ._values import enum, need_numpy
from .body import Thing
from .bulk import floats, place, width_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._values import Rows

T = TypeVar("T")
ParticleField = Literal["position", "linear_velocity", "mass"]


class Particles(Thing):
    """All of it takes and gives numpy arrays (n, 3)."""

    __slots__ = ()
    _destroy = staticmethod(raw.carom_particles_destroy)

    def __len__(self) -> int:
        return int(self._get(raw.carom_particles_get_count, ctypes.c_uint64))

    def add(self, positions: Rows, velocities: Rows | None = None) -> None:
        """m, m/s; without velocities they are at rest."""
        rows = floats(positions)
        address, n, scalar, stride, held = place(rows, 3, None, False)
        fast: int | None = None
        fast_stride, held_too = 0, None
        if velocities is not None:
            fast, _, _, fast_stride, held_too = place(floats(velocities).astype(rows.dtype), 3, n, False)
        self._call(raw.carom_particles_add, n, scalar, address, stride, fast, fast_stride)

    def remove(self, indices: Sequence[int] | NDArray[Any]) -> None:
        """The others keep their order."""
        chosen = (ctypes.c_uint32 * len(indices))(*indices)
        self._call(raw.carom_particles_remove, chosen, len(chosen))

    @overload
    def read(self, field: ParticleField | int = "position", out: None = None,
             dtype: Literal["float64"] = "float64") -> NDArray[np.float64]: ...

    @overload
    def read(self, field: ParticleField | int = "position", out: None = None, *,
             dtype: Literal["float32"]) -> NDArray[np.float32]: ...

    @overload
    def read(self, field: ParticleField | int = "position", *, out: T) -> T: ...

    def read(self, field: ParticleField | int = "position", out: Any = None, dtype: Any = "float64") -> Any:
        """ "position", "linear_velocity" or "mass" of all of them."""
        np = need_numpy("Particles.read()")
        number = enum("FIELD", field)
        n, width = len(self), width_of(number)
        out = np.empty((n, width), dtype) if out is None else out
        address, _, scalar, stride, held = place(out, width, n, True)
        self._call(raw.carom_particles_read, number, scalar, None, n, address, stride)
        return out

    def write(self, field: ParticleField | int, values: Any) -> None:
        number = enum("FIELD", field)
        address, n, scalar, stride, held = place(floats(values), width_of(number), len(self), False)
        self._call(raw.carom_particles_write, number, scalar, None, n, address, stride)
