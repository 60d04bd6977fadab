"""Solving cases: one, many, and questions about one."""

import ctypes
import itertools
import json
import math
import os
import threading
from collections.abc import Mapping

import numpy as np

from . import _native
from ._case import Case, _bytes
from ._native import Batch, DashpadFaults, Fault, checked, library


def _listed(text_at):
    """The texts that a function gives for 0, 1, ... until there is none."""
    return [text.decode() for text in itertools.takewhile(lambda text: text is not None, map(text_at, itertools.count()))]


_columns = _listed(library.dashpad_history_key)

#: The SI unit of each figure of a result, by its key.
figures = dict(zip(_listed(library.dashpad_figure_key), _listed(library.dashpad_figure_unit)))


class _Solvers(threading.local):
    """A solver for each thread."""

    def __init__(self):
        self.handle = library.dashpad_solver_new()

    def __del__(self):
        library.dashpad_solver_free(self.handle)


_solvers = _Solvers()


class _Column:
    """Memory of a result as NumPy sees it, which keeps the result alive."""

    def __init__(self, result, address, size):
        self.result = result
        self.__array_interface__ = {"version": 3, "typestr": "<f8", "shape": (size,), "data": (address, True)}


class _History(Mapping):
    def __init__(self, result):
        self._result = result

    def __getitem__(self, name):
        size = ctypes.c_size_t()
        address = library.dashpad_result_history(self._result._handle, _bytes(name), ctypes.byref(size))
        if not address:
            raise KeyError(name)
        return np.asarray(_Column(self._result, ctypes.cast(address, ctypes.c_void_p).value, size.value))

    def __iter__(self):
        return (name for name in (*_columns, *(f"layer_strain_{i}" for i in range(1, 9))) if self._has(name))

    def _has(self, name):
        return bool(library.dashpad_result_history(self._result._handle, name.encode(), None))

    def __len__(self):
        return sum(1 for _ in self)

    def __repr__(self):
        return f"<history: {', '.join(self)}>"


class Result:
    """A solved case. Every figure is an attribute, in SI: ``result.peak_acceleration``, ``result.hic15``; NaN if the impact
    does not have it. ``dashpad.figures`` lists them with their units."""

    def __init__(self, handle, case):
        self._handle = handle
        self.case = case

    def __del__(self):
        library.dashpad_result_free(self._handle)

    def __getattr__(self, name):
        if name in figures:
            return library.dashpad_result_figure(self._handle, name.encode())
        raise AttributeError(f"a result has no {name}; its figures are {', '.join(figures)}")

    def __dir__(self):
        return [*super().__dir__(), *figures]

    @property
    def status(self):
        """ "released", "bottomed out", "time limit", "tolerance not met" or "at rest"."""
        return library.dashpad_result_status(self._handle).decode()

    @property
    def is_trustworthy(self):
        """Whether the figures may be relied on to the tolerance."""
        return bool(library.dashpad_result_is_trustworthy(self._handle))

    @property
    def flags(self):
        """The reservations about the result, a line each."""
        return _listed(lambda i: library.dashpad_result_flag(self._handle, i))

    @property
    def history(self):
        """Columns over time by name, in SI: arrays that are not copied and cannot be written."""
        return _History(self)

    @property
    def data(self):
        """All of it as ``dashpad run --no-intervals --json`` writes it."""
        return json.loads(library.dashpad_result_json(self._handle))

    def __repr__(self):
        peak = self.peak_acceleration
        shown = f"peak {peak / 9.80665:.4g} g" if peak == peak else "no finite peak"
        return f"<dashpad.Result: {shown}, {self.status}>"

    def _repr_html_(self):
        return assess(self.case)._repr_html_()


def solve(case, *, tolerance=None):
    """Solves a case, to a relative error from 1e-8 to 1e-2 (default: that of the case). Takes what :class:`Case` takes."""
    case = Case(case)
    handle = checked(
        library.dashpad_solve, _solvers.handle, case._handle, 0.0 if tolerance is None else float(tolerance)
    )
    return Result(handle, case)


class Answer:
    """An answer in words, ``title``, with what it rests on: ``data`` as the command writes it with ``--json`` (None where it
    writes none) and the page of the command, which notebooks show."""

    def __init__(self, given):
        self.title = given.get("title", "")
        self.data = given.get("result")
        self.html = given.get("html", "")
        self.card = given.get("card")

    def __repr__(self):
        return f"<dashpad.Answer: {self.title}>"

    def _repr_html_(self):
        return self.html or f"<p>{self.title}</p>"


_units = ("si", "us", "engineering-metric")
_texts = ("standard", "key", "thickness", "area", "rate")


def _ask(request, case=None):
    for name in _texts:
        if not isinstance(request.get(name, ""), str):
            raise TypeError(f"{name} is a text, not {request[name]!r}")
    if request.get("units", "si") not in _units:
        raise ValueError(f"units are one of {', '.join(_units)}, not {request['units']!r}")
    if any(isinstance(value, float) and not math.isfinite(value) for value in request.values()):
        raise ValueError("a number is not finite")
    given = None if case is None else case._handle
    place = library.dashpad_answer(
        json.dumps(request).encode(), given, _bytes(_native.materials), _bytes(_native.standards)
    )
    if not place:
        raise MemoryError
    answer = json.loads(ctypes.cast(place, ctypes.c_char_p).value)
    library.dashpad_text_free(place)
    if "faults" in answer:
        raise DashpadFaults(
            Fault(*(fault.get(name, 0 if name == "line" else "") for name in Fault._fields)) for fault in answer["faults"]
        )
    return answer


def assess(case, standard="", *, intervals=True, keep_speed=False, keep_nose=False, tolerance=None, units="si", **values):
    """The verdict of a standard ("en-1078", "en-960:a"), with the 95 % intervals of all figures; without a standard the
    figures alone. ``mass``, ``radius`` and ``speed`` replace those of the standard."""
    unknown = set(values) - {"mass", "radius", "speed"}
    if unknown:
        raise TypeError(f"assess() has no {', '.join(sorted(unknown))}")
    request = {"do": "solve", "standard": standard, "intervals": intervals, "whole": True, "keep_speed": keep_speed,
               "keep_nose": keep_nose, "units": units, **values}
    if tolerance is not None:
        request["tolerance"] = tolerance
    return Answer(_ask(request, Case(case)))


def solve_for(case, key, *, until=(), standard="", intervals=True, units="si"):
    """The values of ``key`` at which limits are reached: those of a standard, or ``until``, such as
    ``"peak_acceleration <= 80 g"``, one or several."""
    limits = [until] if isinstance(until, str) else list(until)
    return Answer(_ask({"do": "solve-for", "key": key, "until": limits, "standard": standard, "intervals": intervals,
                        "units": units}, Case(case)))


def fit(*files, thickness="", area="", rate="", units="si"):
    """A foam from the tables of compression tests (CSV), as ``dashpad fit --auto`` makes it: ``card`` is the material card,
    None if the fit does not converge. Specimen ``thickness`` and ``area``, or ``rate``, are texts with units where the
    files lack them."""
    given = {"thickness": thickness, "area": area, "rate": rate}
    return Answer(_ask({"do": "fit", "files": [os.fspath(file) for file in files], "units": units,
                        **{name: text for name, text in given.items() if text}}))


def standards():
    """The titles of the standards, by name."""
    return {each["name"]: each["title"] for each in _ask({"do": "list"})["standards"]}


def _column(values):
    """Real numbers as an array; a TypeError for others."""
    return np.atleast_1d(np.asarray(values)).astype(float, casting="same_kind")


def batch(case, rows, figures=("peak_acceleration", "hic15"), *, tolerance=None, threads=0, progress=None):
    """Solves a case once for each row of a table, on all cores.

    ``rows`` maps keys of the case to numbers in SI, arrays of one length or single numbers: a dictionary or a data frame.
    Returns a dictionary of arrays, or a data frame with the same index: a column for each figure in SI, NaN where an
    impact does not have it, with ``status`` and ``error``, the largest estimated relative error of the figures.
    ``progress(done, rows)`` is called now and then, from another thread. Ctrl-C ends the batch.

    >>> import numpy as np
    >>> drop = Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
    ...             pad={"thickness": "40 mm", "material": "eps-29"}, support={"type": "rigid"})
    >>> found = batch(drop, {"impactor.speed": np.linspace(3, 5, 100)})
    >>> found["hic15"].shape, found["status"][0]
    ((100,), 'released')
    """
    if not hasattr(rows, "keys"):
        raise TypeError(f"rows are a dictionary or a data frame, not {type(rows).__name__}")
    keys = [str(key) for key in rows.keys()]
    if not 0 <= threads <= 4096:
        raise ValueError(f"threads are from 1 to 4096, or 0 for one a core, not {threads}")
    names = [figures] if isinstance(figures, str) else list(figures)
    columns = np.broadcast_arrays(*(_column(rows[key]) for key in rows.keys())) if keys else []
    if any(column.ndim != 1 for column in columns):
        raise ValueError("each column of the rows has one dimension")
    table = np.ascontiguousarray(np.stack(columns, axis=1)) if keys else np.empty((0, 0))
    count = len(table)
    results = np.full((count, len(names)), np.nan)
    statuses = np.zeros(count, dtype=np.uint8)
    errors = np.full(count, np.nan)
    stop = threading.Event()
    failed = []

    def told(_, done, all_rows):
        try:
            if progress is not None:
                progress(done, all_rows)
        except BaseException as error:  # handed on to the caller
            failed.append(error)
            stop.set()
        return 0 if stop.is_set() else 1

    def texts(words):
        return (ctypes.c_char_p * len(words))(*(_bytes(word) for word in words))

    asked = Batch(count, texts(keys), len(keys), table.ctypes.data, texts(names), len(names),
                  0.0 if tolerance is None else float(tolerance), int(threads), _native.progress_function(told), None)
    given = Case(case)

    def work():
        try:
            checked(library.dashpad_solve_batch, given._handle, ctypes.byref(asked), results.ctypes.data,
                    statuses.ctypes.data, errors.ctypes.data)
        except BaseException as error:
            failed.append(error)

    # Signals reach the main thread only while it runs Python.
    worker = threading.Thread(target=work)
    worker.start()
    try:
        while worker.is_alive():
            worker.join(0.05)
    except BaseException:
        stop.set()
        worker.join()
        raise
    if failed:
        raise failed[0]
    words = np.array([(library.dashpad_status_name(i) or b"").decode() for i in range(6)], dtype=object)
    found = {**{name: results[:, i] for i, name in enumerate(names)}, "status": words[statuses], "error": errors}
    return type(rows)(found, index=rows.index) if hasattr(rows, "iloc") else found


