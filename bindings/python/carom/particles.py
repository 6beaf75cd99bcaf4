"""Sets of point masses, told apart by their place in the set."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Literal, Sequence, TypeVar, overload

from . import raw
from ._values import enum, floats, listed, need_numpy, set_field, whole
from .body import Thing
from .bulk import place, width_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from typing_extensions import Unpack

    from ._values import Rows
    from .records import ParticlesKeywords

T = TypeVar("T")
ParticleField = Literal["position", "linear_velocity", "mass"]


class Particles(Thing):
    """All of it takes and gives numpy arrays (n, 3)."""

    __slots__ = ()
    _destroy = staticmethod(raw.carom_particles_destroy)

    def _about(self) -> str:
        return f"{len(self)} of them"

    def __len__(self) -> int:
        return int(self._get(raw.carom_particles_get_count, ctypes.c_uint64))

    def add(self, positions: Rows, velocities: Rows | None = None) -> None:
        """m, m/s; without velocities they are at rest."""
        rows = floats(positions, "positions")
        address, n, scalar, stride, held = place(rows, 3, None, "positions")
        fast: int | None = None
        fast_stride, held_too = 0, None
        if velocities is not None:
            fast, _, _, fast_stride, held_too = place(floats(velocities, "velocities").astype(rows.dtype), 3, n, "velocities")
        self._call(raw.carom_particles_add, n, scalar, address, stride, fast, fast_stride)

    def remove(self, indices: Sequence[int] | NDArray[Any]) -> None:
        """The others keep their order."""
        numbers = [whole(index, f"indices[{i}]") for i, index in enumerate(listed(indices, "indices", "whole numbers"))]
        chosen = (ctypes.c_uint32 * len(numbers))(*numbers)
        self._call(raw.carom_particles_remove, chosen, len(chosen))

    def update(self, **about: Unpack[ParticlesKeywords]) -> None:
        """@param about  gravity_factor, linear_damping, mass, capacity; those that are not named stay. Particles that are there keep
        their mass."""
        desc = raw.carom_particles_desc(struct_size=ctypes.sizeof(raw.carom_particles_desc))
        self._call(raw.carom_particles_get, ctypes.byref(desc))
        for key, value in about.items():
            if value is not None:
                set_field(desc, key, value)
        self._call(raw.carom_particles_update, ctypes.byref(desc))

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
        number = enum("FIELD", field, "field")
        n, width = len(self), width_of(number)
        out = np.empty((n, width), dtype) if out is None else out
        address, _, scalar, stride, held = place(out, width, n, "out", writable=True)
        self._call(raw.carom_particles_read, number, scalar, None, n, address, stride)
        return out

    def write(self, field: ParticleField | int, values: Any) -> None:
        number = enum("FIELD", field, "field")
        address, n, scalar, stride, held = place(floats(values, "values"), width_of(number), len(self), "values")
        self._call(raw.carom_particles_write, number, scalar, None, n, address, stride)
