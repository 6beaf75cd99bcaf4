"""What a model has that a world does not get, and why."""
from __future__ import annotations

from typing import Iterable, NamedTuple


class ModelError(ValueError):
    """A model that can't be loaded: where, what is wrong, what to do."""

    def __init__(self, place: str, what: str, remedy: str) -> None:
        super().__init__(f"{place}: {what}; {remedy}")
        self.place, self.what, self.remedy = place, what, remedy


class LeftOut(NamedTuple):
    """Elements of one kind that a world does not get, or gets otherwise, for one reason."""
    kind: str  # MuJoCo's word: "tendon", "equality", "sensor", ...
    names: tuple[str, ...]
    reason: str

    def __str__(self) -> str:
        some = ", ".join(self.names[:3]) + (f" and {len(self.names) - 3} more" if len(self.names) > 3 else "")
        return f"{self.kind} {some}: {self.reason}" if some else f"{self.kind}: {self.reason}"


class Problems:
    """Gathers, one entry for each kind and reason."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], list[str]] = {}

    def add(self, kind: str, names: str | Iterable[str], reason: str) -> None:
        names = [names] if isinstance(names, str) else list(names)
        among = self._found.setdefault((kind, reason), [])
        among += [name for name in names if name not in among]

    def listed(self) -> list[LeftOut]:
        return [LeftOut(kind, tuple(names), reason) for (kind, reason), names in self._found.items()]
