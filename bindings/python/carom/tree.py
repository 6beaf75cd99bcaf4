"""Trees of joints, as robots are made of: coordinates, the forces that accelerations take, mass matrix."""
from __future__ import annotations

import array
import ctypes
from typing import TYPE_CHECKING, Any

from . import raw
from ._values import copy_out, numpy, record, vector
from .joint import AXES
from .records import TreeCoordinateRecord

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._values import Vector
    from .body import Body


class JointTree:
    """What joints hold together without a loop: `world.tree(body)`, of any dynamic body of it. carom/tree.h says in which order and
    frames the coordinates stand. Numpy arrays, or array.array without numpy (a matrix row by row)."""

    __slots__ = ("body", "size")

    def __init__(self, body: Body) -> None:
        self.body = body
        self.size = len(self._listed())

    def __len__(self) -> int:
        return self.size

    def __repr__(self) -> str:
        return f"<carom.JointTree of {self.body!r}: {self.size} coordinates>"

    def _listed(self) -> Any:
        return copy_out(self.body.world._call, raw.carom_tree_get_coordinates, raw.carom_tree_coordinate, self.body.handle)

    @property
    def coordinates(self) -> list[TreeCoordinateRecord]:
        """Of each its joint (None: of the base), the body that it moves, and its axis: "x", ..., "turn_z"."""
        return [record(TreeCoordinateRecord, one, self.body.world._wrap, axis=AXES[one.axis]) for one in self._listed()]

    @property
    def speeds(self) -> NDArray[np.float64]:
        """m/s and rad/s, (n,)"""
        out = (ctypes.c_double * self.size)()
        self.body.world._call(raw.carom_tree_get_speeds, self.body.handle, out, self.size)
        return self._array(out)  # type: ignore[no-any-return]

    def forces(self, accelerations: Vector | None = None, speeds: Vector | None = None) -> NDArray[np.float64]:
        """Inverse dynamics: N and N m, (n,), that give these accelerations at the present pose, against gravity.
        @param accelerations  (n,), rates of the speeds; None: 0   @param speeds  (n,); None: those of now. [0] * len(tree) holds still"""
        out = (ctypes.c_double * self.size)()
        given = [None if x is None else (ctypes.c_double * self.size)(*vector(x, self.size, name))
                 for x, name in ((speeds, "speeds"), (accelerations, "accelerations"))]
        self.body.world._call(raw.carom_tree_get_forces, self.body.handle, *given, out, self.size)
        return self._array(out)  # type: ignore[no-any-return]

    @property
    def mass(self) -> NDArray[np.float64]:
        """The mass matrix, kg, kg m and kg m^2, (n, n): the energy of motion is speeds @ mass @ speeds / 2."""
        out = (ctypes.c_double * (self.size * self.size))()
        self.body.world._call(raw.carom_tree_get_mass, self.body.handle, out, self.size)
        found: Any = self._array(out)
        return found.reshape(self.size, self.size) if numpy is not None else found  # type: ignore[no-any-return]

    @staticmethod
    def _array(out: Any) -> Any:
        return numpy.array(out) if numpy is not None else array.array("d", bytes(out))
