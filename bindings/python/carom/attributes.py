"""Attributes of a body by name: body.attributes["drag"] = 0.1, 0.02; body.attributes["gravity_factor"] = 0."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Iterable, Iterator, MutableMapping, Sequence

from . import raw
from ._root import check
from ._values import Record, number

if TYPE_CHECKING:
    from .body import Body

class AttributeInfo(Record):
    """What an attribute is."""
    attribute: int
    name: str
    unit: str
    summary: str
    numbers: int
    whole: bool
    min: float
    max: float
    usual: tuple[float, ...]
    of_dynamic: bool
    effect: int


_infos: dict[str, AttributeInfo] = {}


def attribute_infos() -> dict[str, AttributeInfo]:
    """What each attribute is: name, unit, summary, numbers (how many), whole, min, max, usual, effect."""
    if not _infos:
        for attribute in range(raw.CAROM_ATTRIBUTE_COUNT):
            info = raw.carom_attribute_info(struct_size=ctypes.sizeof(raw.carom_attribute_info))
            check(raw.carom_attribute_get_info, attribute, ctypes.byref(info))
            _infos[info.name.decode()] = AttributeInfo(
                attribute=attribute, name=info.name.decode(), unit=info.unit.decode(), summary=info.summary.decode(),
                numbers=info.numbers, whole=bool(info.is_whole), min=info.min, max=info.max,
                usual=tuple(info.usual[:info.numbers]), of_dynamic=bool(info.of_dynamic), effect=info.effect)
    return _infos


class Attributes(MutableMapping[str, "float | Sequence[float]"]):
    """All attributes of a body: a number, or a tuple where there are several."""

    def __init__(self, body: Body):
        self._body = body

    def _info(self, name: str) -> AttributeInfo:
        infos = attribute_infos()
        if name not in infos:
            raise KeyError(f"no attribute {name!r}; there are {', '.join(infos)}")
        return infos[name]

    def __getitem__(self, name: str) -> float | tuple[float, ...]:
        info, value = self._info(name), (ctypes.c_double * 4)()
        self._body._call(raw.carom_body_get_attribute, info.attribute, value)
        numbers = tuple(int(x) if info.whole else x for x in value[:info.numbers])
        return numbers if info.numbers > 1 else numbers[0]

    def __setitem__(self, name: str, value: float | Sequence[float]) -> None:
        info = self._info(name)
        numbers: list[Any] = [value] if isinstance(value, (str, bytes)) or not isinstance(value, Iterable) else list(value)
        if len(numbers) != info.numbers:
            raise ValueError(f"{name} has {info.numbers} numbers ({info.unit}), not {len(numbers)}")
        numbers = [number(x, f"{name}[{i}]" if len(numbers) > 1 else name) for i, x in enumerate(numbers)]
        self._body._call(raw.carom_body_set_attribute, info.attribute, (ctypes.c_double * 4)(*numbers))

    def __delitem__(self, name: str) -> None:
        """Back to what a new body has."""
        self[name] = self._info(name).usual

    def __iter__(self) -> Iterator[str]:
        return iter(attribute_infos())

    def __len__(self) -> int:
        return len(attribute_infos())

    def __repr__(self) -> str:
        return f"Attributes({dict(self)})"
