"""Cases: from files, texts, dictionaries and keywords, with their numbers by dotted keys."""

from __future__ import annotations

import json
import math
import numbers
import os
import pathlib
import re
import tempfile
import threading
import typing
from collections.abc import Iterator, KeysView, Mapping

from . import _native
from ._answer import Answer
from ._native import checked, library

Tables = Mapping[str, typing.Any]


def _toml(value: typing.Any) -> str:
    """A value as TOML, tables inline."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        number = float(value)
        return repr(number) if math.isfinite(number) else ("nan" if math.isnan(number) else f"{number}")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(key)} = {_toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
        return "[" + ", ".join(_toml(each) for each in (value.tolist() if hasattr(value, "tolist") else value)) + "]"
    raise TypeError(f"a case holds texts, numbers, lists and tables, not {type(value).__name__}")


def _key(key: typing.Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"a key of a case is a text, not {key!r}")
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key)


_own_cards: tempfile.TemporaryDirectory[str] | None = None


def _with_own_cards(value: typing.Any) -> typing.Any:
    """The tables, with each foam that a fit has made as a file: cases name their foams by file or name."""
    global _own_cards
    if isinstance(value, Mapping):
        return {key: _with_own_cards(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_with_own_cards(each) for each in value]
    if not isinstance(value, Answer):
        return value
    if value.card is None:
        raise ValueError("this answer has no foam: the fit did not converge, or it is none")
    _own_cards = _own_cards or tempfile.TemporaryDirectory()
    title = re.search('^title = "([^"]*)"', value.card, re.MULTILINE)
    name = re.sub(r"\W+", "-", title[1] if title else "").strip("-") or "foam"
    folder = pathlib.Path(tempfile.mkdtemp(dir=_own_cards.name))
    (folder / f"{name}.toml").write_text(value.card, encoding="utf-8")
    return str(folder / f"{name}.toml")


def toml_of_tables(tables: Tables) -> str:
    """Tables as a TOML file."""
    return "".join(f"{_key(key)} = {_toml(value)}\n" for key, value in tables.items())


class Case:
    """A case: impactor, pad and support.

    ``source`` is the path of a case file, the text of one (with a line break), or a dictionary of its tables; or the
    tables are given as keywords, with units as in case files. ``materials`` is the folder of the foam cards (default: those supplied).

    ``case["pad.thickness"]`` reads a number in SI; ``case["pad.thickness"] = 0.03`` or ``"30 mm"`` sets it, and other keys of
    case files take texts (``case["pad.material"] = "vn600"``). ``case | {...}`` gives a changed copy. What makes the case
    invalid raises :class:`DashpadFaults` and leaves it as it was.

    >>> case = Case({"impactor": {"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
    ...              "pad": {"thickness": "40 mm", "material": "eps-29"}, "support": {"type": "rigid"}})
    >>> case["pad.thickness"], case.units["pad.thickness"]
    (0.04, 'm')
    """

    __slots__ = ("_handle", "_lock", "__weakref__")

    def __init__(self, source: CaseLike | None = None, /, *, materials: str | os.PathLike[str] | None = None, **tables: Tables):
        self._handle: int | None = None
        # Texts of a case go when it changes.
        self._lock = threading.RLock()
        if source is not None and tables:
            raise TypeError("give a case either by one argument or by keywords")
        if isinstance(source, Case):
            with source._lock:
                self._handle = library.dashpad_case_copy(source._handle)
            return
        file, text = "the case", None
        if source == "":
            raise ValueError("a case is a path, a text or a dictionary, not an empty text")
        if isinstance(source, os.PathLike) or (isinstance(source, str) and "\n" not in source):
            file = os.fspath(source)
        elif isinstance(source, str):
            text = source
        elif source is None or isinstance(source, Mapping):
            text = toml_of_tables(_with_own_cards(tables if source is None else source))
        else:
            raise TypeError(f"a case is a path, a text or a dictionary, not {type(source).__name__}")
        folder = os.fspath(materials) if materials is not None else _native.materials
        self._handle = checked(
            library.dashpad_case_read, _bytes(file), None if text is None else _bytes(text), _bytes(folder)
        )

    def __del__(self) -> None:
        handle, self._handle = getattr(self, "_handle", None), None
        library.dashpad_case_free(handle)

    def __getitem__(self, key: str) -> float:
        with self._lock:
            value = float(library.dashpad_case_number(self._handle, _bytes(key)))
        if value != value and key not in self.units:
            raise KeyError(key)
        return value

    def __setitem__(self, key: str, value: float | str) -> None:
        value = _with_own_cards(value)
        if isinstance(value, str):
            with self._lock:
                checked(library.dashpad_case_set, self._handle, _bytes(key), _bytes(value))
        elif isinstance(value, numbers.Real) and not isinstance(value, bool):
            with self._lock:
                checked(library.dashpad_case_set_number, self._handle, _bytes(key), float(value))
        else:
            raise TypeError(f"{key} is set to a number or a text, not to {type(value).__name__}")

    def __or__(self, changes: Mapping[str, float | str]) -> Case:
        if not isinstance(changes, Mapping):
            return NotImplemented
        changed = Case(self)
        for key, value in changes.items():
            changed[key] = value
        return changed

    def __iter__(self) -> Iterator[str]:
        return iter(self.units)

    def __len__(self) -> int:
        return int(library.dashpad_case_size(self._handle))

    def __contains__(self, key: object) -> bool:
        return key in self.units

    def keys(self) -> KeysView[str]:
        """The keys of the numbers that the case has."""
        return self.units.keys()

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each number, by its key; "1" for a pure number."""
        with self._lock:
            return {
                library.dashpad_case_key(self._handle, i).decode(): library.dashpad_case_unit(self._handle, i).decode()
                for i in range(len(self))
            }

    @property
    def toml(self) -> str:
        """The case as a case file in SI that needs no other files."""
        with self._lock:
            return str(library.dashpad_case_toml(self._handle).decode())

    def __repr__(self) -> str:
        mass, speed, thickness = (self[key] for key in ("impactor.mass", "impactor.speed", "pad.thickness"))
        return f"<dashpad.Case: {mass:.4g} kg at {speed:.4g} m/s on a pad of {1e3 * thickness:.4g} mm; all of it is in its toml>"

    def __copy__(self) -> Case:
        return Case(self)

    def __deepcopy__(self, _: typing.Any) -> Case:
        return Case(self)

    def __reduce__(self) -> tuple[type[Case], tuple[str]]:
        return Case, (self.toml,)


def _bytes(text: typing.Any) -> bytes:
    if not isinstance(text, str):
        raise TypeError(f"{text!r} is no text")
    if "\0" in text:
        raise ValueError("a text must not contain a null character")
    return text.encode()


#: What a case is made from: another case, a path, the text of a case file, or its tables.
CaseLike = typing.Union[Case, str, "os.PathLike[str]", Tables]
