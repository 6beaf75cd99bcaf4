"""One exception for each result code, with what is wrong and what to do in its text."""
from __future__ import annotations

import re

from . import raw


class CaromError(Exception):
    """A call that the library refused; nothing has changed.

    code      the result, raw.CAROM_E_*
    message   what is wrong, with the numbers
    remedy    what to do next
    argument  1-based position of the argument at fault in the C signature, 0: none in particular
    witness   (direction, answer) that prove a support function false, or None
    """
    code = 0

    def __init__(self, message: str, remedy: str = "", argument: int = 0, witness=None, code: int | None = None):
        super().__init__(f"{message}. Remedy: {remedy}" if remedy else message)
        self.message, self.remedy, self.argument, self.witness = message, remedy, argument, witness
        if code is not None:
            self.code = code


# Where Python has a word for it, the exception is that one, too.
_ALSO = {"NOT_FINITE": ValueError, "OUT_OF_RANGE": ValueError, "NOT_UNIT": ValueError, "UNKNOWN_ENUM": ValueError,
         "NULL_ARGUMENT": ValueError, "INVALID_HANDLE": ReferenceError, "STALE_HANDLE": ReferenceError,
         "WRONG_KIND": TypeError, "OUT_OF_MEMORY": MemoryError, "NOT_FOUND": LookupError, "UNSUPPORTED": NotImplementedError,
         "PLUGIN_PATH": OSError, "PLUGIN_LOAD": OSError, "BUFFER_TOO_SMALL": ValueError,
         "CORRUPT": ValueError, "MISMATCH": ValueError,
         "WRITE_FAILED": OSError}


def _make(word):
    also = _ALSO.get(word)
    value = getattr(raw, "CAROM_E_" + word)
    bases = (CaromError, also) if also else (CaromError,)
    doc = f"{raw.carom_result_name(value).decode()}: {raw.carom_result_remedy(value).decode()}."
    return type("".join(part.capitalize() for part in word.split("_")), bases, {"code": value, "__doc__": doc, "__module__": __name__})


BY_CODE = {}
for _name in dir(raw):
    if _name.startswith("CAROM_E_"):
        _class = _make(_name[len("CAROM_E_"):])
        BY_CODE[_class.code] = globals()[_class.__name__] = _class


class Closed(CaromError, ReferenceError):
    """The engine or world was closed, or the object's handle is no longer anybody's."""


def as_typed(refused: CaromError, names: tuple[str, ...], first: int) -> CaromError:
    """The same refusal in the words of what was typed, where C has other words for its arguments.
    @param first  position in C of the argument that names[0] is"""
    index = refused.argument - first
    if not 0 <= index < len(names):
        return refused
    about = re.sub(r"^\w+", names[index], refused.message, count=1)
    return type(refused)(about, refused.remedy, refused.argument, refused.witness, refused.code)


def raise_for(result: int, error: raw.carom_error | None) -> None:
    """Raise what `result` calls for; `error`, where the call filled one, has the details."""
    kind = BY_CODE.get(result, CaromError)
    if error is None or error.code != result:
        text = lambda words: words.decode("utf-8", "replace")  # noqa: E731
        raise kind(text(raw.carom_result_name(result)), text(raw.carom_result_remedy(result)), code=result)
    witness = (tuple(error.witness_dir), tuple(error.witness_out)) if error.has_witness else None
    raise kind(error.message.decode("utf-8", "replace"), error.remedy.decode("utf-8", "replace"), error.argument, witness, result)
