"""The functions of dashpad.h, by ctypes, and faults as exceptions."""

from __future__ import annotations

import ctypes
import os
import pathlib
import typing
from collections.abc import Iterable

here = pathlib.Path(__file__).resolve().parent


def _first(*candidates: pathlib.Path) -> pathlib.Path:
    return next((path for path in candidates if path.exists()), candidates[0])


_source = here.parents[1]
library_file = pathlib.Path(
    os.environ.get("DASHPAD_LIBRARY")
    or _first(here / "libdashpad.so.1", _source / "build/release/c/libdashpad.so.1")
)
materials = os.environ.get("DASHPAD_MATERIALS") or str(_first(here / "materials", _source / "materials"))
standards = os.environ.get("DASHPAD_STANDARDS") or str(_first(here / "standards", _source / "standards"))

command_file = pathlib.Path(
    os.environ.get("DASHPAD_COMMAND") or _first(here / "bin/dashpad", _source / "build/release/app/dashpad")
)

handle = ctypes.c_void_p
text = ctypes.c_char_p
size = ctypes.c_size_t
number = ctypes.c_double


class _Fault(ctypes.Structure):
    _fields_ = [("file", text), ("line", ctypes.c_int), ("key", text), ("value", text), ("rule", text), ("text", text)]


progress_function = ctypes.CFUNCTYPE(ctypes.c_int, handle, size, size)


class Batch(ctypes.Structure):
    _fields_ = [
        ("rows", size),
        ("keys", ctypes.POINTER(text)),
        ("keys_size", size),
        ("values", handle),
        ("figures", ctypes.POINTER(text)),
        ("figures_size", size),
        ("tolerance", number),
        ("threads", ctypes.c_int),
        ("progress", progress_function),
        ("context", handle),
        ("flags", handle),
    ]


_functions: dict[str, tuple[typing.Any, ...]] = {
    "dashpad_interface": (ctypes.c_int,),
    "dashpad_version": (text,),
    "dashpad_faults_size": (size, handle),
    "dashpad_faults_at": (_Fault, handle, size),
    "dashpad_faults_free": (None, handle),
    "dashpad_case_read": (handle, text, text, text, ctypes.POINTER(handle)),
    "dashpad_case_copy": (handle, handle),
    "dashpad_case_free": (None, handle),
    "dashpad_case_set": (ctypes.c_int, handle, text, text, ctypes.POINTER(handle)),
    "dashpad_case_set_number": (ctypes.c_int, handle, text, number, ctypes.POINTER(handle)),
    "dashpad_case_number": (number, handle, text),
    "dashpad_case_size": (size, handle),
    "dashpad_case_key": (text, handle, size),
    "dashpad_case_unit": (text, handle, size),
    "dashpad_case_toml": (text, handle),
    "dashpad_solver_new": (handle,),
    "dashpad_solver_free": (None, handle),
    "dashpad_solve": (handle, handle, handle, number, ctypes.POINTER(handle)),
    "dashpad_result_free": (None, handle),
    "dashpad_result_status": (text, handle),
    "dashpad_result_is_trustworthy": (ctypes.c_int, handle),
    "dashpad_result_figure": (number, handle, text),
    "dashpad_figures_size": (size,),
    "dashpad_figure_key": (text, size),
    "dashpad_figure_unit": (text, size),
    "dashpad_figure_title": (text, size),
    "dashpad_result_flags_size": (size, handle),
    "dashpad_result_flag": (text, handle, size),
    "dashpad_result_history": (ctypes.POINTER(number), handle, text, ctypes.POINTER(size)),
    "dashpad_history_key": (text, size),
    "dashpad_result_json": (text, handle),
    "dashpad_solve_batch": (
        ctypes.c_int, handle, ctypes.POINTER(Batch), handle, handle, handle, ctypes.POINTER(handle),
    ),
    "dashpad_status_name": (text, ctypes.c_ubyte),
    "dashpad_answer": (handle, text, handle, text, text),
    "dashpad_text_free": (None, handle),
}


class Fault(typing.NamedTuple):
    """What is wrong: its place, the value found there, and the rule that it breaks."""

    file: str
    line: int
    key: str
    value: str
    rule: str
    text: str


class DashpadFaults(ValueError):
    """Input that cannot be computed. ``faults`` has all of it as data, the message as text."""

    def __init__(self, faults: Iterable[Fault]):
        self.faults = tuple(faults)
        super().__init__("\n".join(fault.text for fault in self.faults))

    def __reduce__(self) -> tuple[type[DashpadFaults], tuple[tuple[Fault, ...]]]:
        return DashpadFaults, (self.faults,)


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(str(library_file))
    for name, (result, *arguments) in _functions.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    if library.dashpad_interface() != interface:
        raise ImportError(f"{library_file} has interface {library.dashpad_interface()}, not {interface}")
    return library


interface = 1
library = _load()


def checked(function: typing.Any, *arguments: typing.Any) -> typing.Any:
    """The result of a function whose last argument takes faults."""
    faults = handle()
    result = function(*arguments, ctypes.byref(faults))
    if faults:
        found = [
            Fault(*(value.decode(errors="replace") if isinstance(value, bytes) else value for value in (
                fault.file, fault.line, fault.key, fault.value, fault.rule, fault.text)))
            for fault in (library.dashpad_faults_at(faults, i) for i in range(library.dashpad_faults_size(faults)))
        ]
        library.dashpad_faults_free(faults)
        raise DashpadFaults(found)
    return result
