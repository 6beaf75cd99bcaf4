"""Shapes written in Python: one function, (params, direction) -> farthest point.

The contract is that of carom/plugin.h: pure, `direction` of any positive length, the same answer for the same direction;
no call of this package from inside. It is called on the thread that makes the call (HOST_THREAD), thousands of times a
second, so such a shape is for trying out; ask Python for it, then write it in C.
"""
from __future__ import annotations

import ctypes
import sys
import traceback
from typing import TYPE_CHECKING, Any, Callable, Sequence, TypeVar

from . import raw
from ._values import enum, listed, number, whole
from .errors import CaromError
from .shape import Shape

if TYPE_CHECKING:
    from .engine import Engine
    from .records import FormWord

T = TypeVar("T")
Support = Callable[[Sequence[float], "tuple[float, float, float]"], Sequence[float]]  # (params, direction) -> point

_DOUBLE3 = ctypes.c_double * 3


def _guarded(support: Support, caught: list[BaseException | None]) -> Any:
    """The function that C calls. An exception is a fault of the shape; it is kept for whoever asked; in a
    step, which goes on without the shape, it is printed."""
    def call(user: Any, params: Any, count: int, direction: Any, out: Any) -> int:
        try:
            out[0], out[1], out[2] = support(params[:count], (direction[0], direction[1], direction[2]))
            return 0
        except BaseException as exception:  # nothing may fly through C
            if caught and caught[-1] is None:
                caught[-1] = exception
            else:
                print("carom: a support function raised; its shape is disabled from now on (World.faults tells)", file=sys.stderr)
                traceback.print_exception(type(exception), exception, exception.__traceback__)
            return 1
    return raw.carom_support_fn(call)


class SupportPlugin:
    """A kind of shape; call it with parameters to make one.

    params       [(name, unit, min, max)]: bounds are checked when a shape is made
    form, args   what closed form it is, in words ("box"), and the indices of its parameters; verified, never trusted
    core_radius  index of the parameter that is the core radius: the function is then that of the core
    version      raise it when the same parameters mean another shape
    """

    def __init__(self, engine: Engine, support: Support, id: str, params: Sequence[tuple[str, str, float, float]] = (),
                 form: FormWord | None = None, args: Sequence[int] = (), core_radius: int | None = None, version: int = 1,
                 tail_group: int = 0, tail_min: int = 0):
        self.engine, self.id = engine, id
        self._caught: list[BaseException | None] = []
        version, tail_group, tail_min = whole(version, "version"), whole(tail_group, "tail_group"), whole(tail_min, "tail_min")
        indices = [whole(index, f"args[{i}]") for i, index in enumerate(listed(args, "args", "indices of parameters"))]
        core = raw.CAROM_NO_PARAM if core_radius is None else whole(core_radius, "core_radius")
        what = "rows of name, unit, min, max"
        rows = [listed(row, f"params[{i}]", "name, unit, min, max") for i, row in enumerate(listed(params, "params", what))]
        if any(len(row) != 4 for row in rows):
            raise ValueError(f"params takes {what}, got {params!r}")
        params = [(str(n), str(u), number(low, f"min of params[{i}]"), number(high, f"max of params[{i}]"))
                  for i, (n, u, low, high) in enumerate(rows)]
        table = (raw.carom_param * len(params))(*[raw.carom_param(n.encode(), u.encode(), low, high) for n, u, low, high in params])
        callback = _guarded(support, self._caught)
        plugin = raw.carom_shape_plugin(
            struct_size=ctypes.sizeof(raw.carom_shape_plugin), abi_major=raw.CAROM_PLUGIN_ABI_MAJOR,
            abi_minor=raw.CAROM_PLUGIN_ABI_MINOR, flags=raw.CAROM_PLUGIN_HOST_THREAD, id=id.encode(), version=version,
            param_count=len(params), params=table, support=callback, param_tail_group=tail_group, param_tail_min=tail_min)
        geometry = None
        if form is not None or core_radius is not None:
            if len(indices) > 4:
                raise ValueError(f"args takes up to 4 indices of parameters, got {len(indices)}")
            arg = (ctypes.c_uint32 * 4)(*indices, *[raw.CAROM_NO_PARAM] * (4 - len(indices)))
            kind = enum("FORM", form or "none", "form")
            geometry = raw.carom_geometry(
                struct_size=ctypes.sizeof(raw.carom_geometry), form=kind, form_arg=arg, mass_form=kind, mass_arg=arg,
                core_radius_param=core)
            plugin.geometry = ctypes.pointer(geometry)
        engine._owner.alive += [table, callback, plugin, geometry]  # as long as the engine
        handle = ctypes.c_uint64()
        self._asking(engine._call, raw.carom_plugin_register, ctypes.byref(plugin), ctypes.byref(handle))
        self.handle = handle.value

    def _asking(self, call: Callable[..., T], *arguments: object) -> T:
        """Make a call; where it fails because the function raised, that exception is its cause."""
        self._caught.append(None)
        try:
            return call(*arguments)
        except CaromError as refused:
            raise refused from self._caught[-1]
        finally:
            self._caught.pop()

    def __call__(self, *params: float) -> Shape:
        return self._asking(self.engine.shape, self.handle, params)
