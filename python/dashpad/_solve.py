"""Solving cases: one, many, and questions about one."""

from __future__ import annotations

import ctypes
import functools
import itertools
import json
import math
import numbers
import os
import threading
import typing
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from . import _native
from ._answer import Answer
from ._case import Case, CaseLike, _bytes
from ._columns import Array, column_of
from ._command import page_of
from ._native import Batch, DashpadFaults, Fault, checked, library


def _listed(text_at: Callable[[int], typing.Any]) -> list[str]:
    """The texts that a function gives for 0, 1, ... until there is none."""
    return [text.decode() for text in itertools.takewhile(lambda text: text is not None, map(text_at, itertools.count()))]


_columns = _listed(library.dashpad_history_key)

#: The SI unit of each figure of a result, by its key.
figures = dict(zip(_listed(library.dashpad_figure_key), _listed(library.dashpad_figure_unit)))


_flags_of_rows = {"extrapolated_strain": 1, "extrapolated_rate": 2, "bottomed": 4}


class _Solvers(threading.local):
    """A solver for each thread."""

    def __init__(self) -> None:
        self.handle = library.dashpad_solver_new()

    def __del__(self) -> None:
        library.dashpad_solver_free(self.handle)


_solvers = _Solvers()


class _Column:
    """Memory of a result as NumPy sees it, which keeps the result alive."""

    def __init__(self, result: Result, address: int | None, size: int):
        self.result = result
        self.__array_interface__ = {"version": 3, "typestr": "<f8", "shape": (size,), "data": (address, True)}


class Result:
    """What :func:`solve` finds. Every figure is an attribute, in SI: ``result.peak_acceleration``, ``result.hic15``; NaN if the
    impact does not have it. ``dashpad.figures`` lists them with their units. A result that is pickled is solved again."""

    __slots__ = ("_handle", "_tolerance", "case")

    def __init__(self, case: Case, tolerance: float = 0.0):
        self._handle: int | None = None
        self.case = case
        self._tolerance = tolerance
        with case._lock:
            self._handle = checked(library.dashpad_solve, _solvers.handle, case._handle, tolerance)

    def __del__(self) -> None:
        handle, self._handle = getattr(self, "_handle", None), None
        library.dashpad_result_free(handle)

    def __copy__(self) -> Result:
        return self

    def __deepcopy__(self, _: typing.Any) -> Result:
        return self

    def __reduce__(self) -> tuple[type[Result], tuple[Case, float]]:
        return Result, (self.case, self._tolerance)

    def __getattr__(self, name: str) -> float:
        if name in figures:
            return float(library.dashpad_result_figure(self._handle, name.encode()))
        raise AttributeError(f"a result has no {name}; its figures are {', '.join(figures)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *figures]

    @property
    def status(self) -> str:
        """ "released", "bottomed out", "time limit", "tolerance not met" or "at rest"."""
        return str(library.dashpad_result_status(self._handle).decode())

    @property
    def met_tolerance(self) -> bool:
        """Whether the figures solve the case to its tolerance. Whether the foam was tested as far is said by ``flags``."""
        return bool(library.dashpad_result_is_trustworthy(self._handle))

    @property
    def flags(self) -> list[str]:
        """The reservations about the result, a line each; by how much they may matter is said by :func:`assess`."""
        return _listed(lambda i: library.dashpad_result_flag(self._handle, i))

    @property
    def history(self) -> dict[str, Array]:
        """Columns over time by name, in SI, with the signs of the theory (an acceleration is negative while the impactor is
        braked): arrays of one length that are not copied and cannot be written."""
        columns = {}
        for name in (*_columns, *(f"layer_strain_{i}" for i in range(1, 9))):
            size = ctypes.c_size_t()
            address = library.dashpad_result_history(self._handle, name.encode(), ctypes.byref(size))
            if address:
                place = ctypes.cast(address, ctypes.c_void_p).value
                columns[name] = np.asarray(_Column(self, place, size.value))
        return columns

    @property
    def data(self) -> dict[str, typing.Any]:
        """All of it as ``dashpad run --no-intervals --json`` writes it."""
        return dict(json.loads(library.dashpad_result_json(self._handle)))

    def plot(self, axes: typing.Any = None) -> typing.Any:
        """Draws the deceleration, g, over time, ms, by matplotlib, in `axes` or a figure of its own; returns the axes."""
        if axes is None:
            from matplotlib import pyplot

            axes = pyplot.figure().subplots()
        history = self.history
        axes.plot(1e3 * history["time"], -history["acceleration"] / 9.80665)
        axes.set(xlabel="Time (ms)", ylabel="Deceleration (g)")
        return axes

    def __repr__(self) -> str:
        peak = self.peak_acceleration
        shown = f"peak {peak / 9.80665:.4g} g" if peak == peak else "no finite peak"
        return f"<dashpad.Result: {shown}, {self.status}>"

    def _repr_html_(self) -> str:
        return assess(self.case)._repr_html_()


def solve(case: CaseLike, *, tolerance: float | None = None) -> Result:
    """Solves a case, to a relative error from 1e-8 to 1e-2 (default: that of the case). Takes what :class:`Case` takes."""
    return Result(Case(case), 0.0 if tolerance is None else float(tolerance))


_units_of_values = {"mass": "kg", "radius": "m", "speed": "m/s"}
_units = ("si", "us", "engineering-metric")
_texts = ("standard", "key", "thickness", "area", "rate")


def _ask(request: dict[str, typing.Any], case: Case | None = None) -> dict[str, typing.Any]:
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
    answer: dict[str, typing.Any] = json.loads(ctypes.cast(place, ctypes.c_char_p).value or b"{}")
    library.dashpad_text_free(place)
    if "faults" in answer:
        raise DashpadFaults(
            Fault(*(fault.get(name, 0 if name == "line" else "") for name in Fault._fields)) for fault in answer["faults"]
        )
    return answer


def assess(case: CaseLike, standard: str = "", *, intervals: bool = True, keep_speed: bool = False, keep_nose: bool = False,
           tolerance: float | None = None, units: str = "si", **values: float | str) -> Answer:
    """The verdict of a standard ("en-1078", "ece-22-06"), with the 95 % intervals of all figures; without a standard the
    figures alone. ``mass``, ``radius`` and ``speed`` replace those of the standard."""
    unknown = set(values) - set(_units_of_values)
    if unknown:
        raise TypeError(f"assess() has no {', '.join(sorted(unknown))}")
    given = Case(case)
    request = {"do": "solve", "standard": standard, "intervals": intervals, "keep_speed": keep_speed, "keep_nose": keep_nose,
               "units": units, **values}
    if tolerance is not None:
        request["tolerance"] = tolerance
    found = _ask(request, given)
    options: dict[str, typing.Any] = {"no_intervals": not intervals, "tolerance": tolerance, "units": units}
    if standard:
        options |= {"standard": standard, "keep_speed": keep_speed, "keep_nose": keep_nose}
        options |= {name: value if isinstance(value, str) else f"{value!r} {_units_of_values[name]}" for name, value in values.items()}
    command = "assess" if standard else "run"
    return Answer(found["title"], found["result"], functools.partial(page_of, command, [], options, given))


def solve_for(case: CaseLike, key: str, *, until: str | Sequence[str] = (), standard: str = "", intervals: bool = True,
              units: str = "si") -> Answer:
    """The values of ``key`` at which limits are reached: those of a standard, or ``until``, such as
    ``"peak_acceleration <= 80 g"``, one or several."""
    limits = [until] if isinstance(until, str) else list(until)
    if not all(isinstance(limit, str) for limit in limits):
        raise TypeError('limits are texts, such as "peak_acceleration <= 80 g"')
    given = Case(case)
    found = _ask({"do": "solve-for", "key": key, "until": limits, "standard": standard, "intervals": intervals, "units": units}, given)
    options = {"until": limits, "standard": standard, "no_intervals": not intervals, "units": units}
    return Answer(found["title"], found["result"], functools.partial(page_of, "solve-for", [key], options, given))


def standards() -> dict[str, str]:
    """The titles of the standards, by name."""
    return {each["name"]: each["title"] for each in _ask({"do": "list"})["standards"]}


def _table(rows: typing.Any) -> tuple[list[str], Array]:
    """The keys of the rows, and their values, one row after the other."""
    if not hasattr(rows, "keys") or getattr(rows, "ndim", 2) != 2:
        raise TypeError(f"rows are a dictionary or a data frame, not {type(rows).__name__}")
    columns = {str(key): column_of(str(key), rows[key]) for key in rows.keys()}
    lengths = {key: len(column) for key, column in columns.items() if len(column) != 1}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"columns of the rows have different lengths: {', '.join(f'{key} {n}' for key, n in lengths.items())}")
    stacked = np.stack(np.broadcast_arrays(*columns.values()), axis=1) if columns else np.empty((0, 0))
    return list(columns), np.ascontiguousarray(stacked)


def batch(case: CaseLike, rows: typing.Any, figures: str | Sequence[str] = ("peak_acceleration", "hic15"), *,
          tolerance: float | None = None, threads: int = 0,
          progress: Callable[[int, int], object] | None = None) -> typing.Any:
    """Solves a case once for each row of a table, on all cores.

    ``rows`` maps keys of the case to numbers in SI, arrays of one length or single numbers: a dictionary or a data frame.
    Returns a dictionary of arrays, or a data frame with the same index: a column for each figure in SI, NaN where an
    impact does not have it, with ``status``; ``error``, the largest estimated relative error of the figures (three times what
    is held to the tolerance); and whether the foam was used beyond its tests, ``extrapolated_strain`` and
    ``extrapolated_rate``, and the pad ``bottomed``.
    ``progress(done, rows)`` is called now and then, from another thread. Ctrl-C ends the batch.

    >>> import numpy as np
    >>> drop = Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
    ...             pad={"thickness": "40 mm", "material": "eps-29"}, support={"type": "rigid"})
    >>> found = batch(drop, {"impactor.speed": np.linspace(3, 5, 100)})
    >>> found["hic15"].shape, found["status"][0]
    ((100,), 'released')
    """
    if not isinstance(threads, numbers.Integral) or not 0 <= threads <= 4096:
        raise ValueError(f"threads are from 1 to 4096, or 0 for one a core, not {threads}")
    names = [figures] if isinstance(figures, str) else list(figures)
    keys, table = _table(rows)
    count = len(table)
    results = np.full((count, len(names)), np.nan)
    statuses = np.zeros(count, dtype=np.uint8)
    errors = np.full(count, np.nan)
    flags = np.zeros(count, dtype=np.uint8)
    stop, ended = threading.Event(), threading.Event()
    failed: list[BaseException] = []

    def told(_: object, done: int, all_rows: int) -> int:
        try:
            if progress is not None:
                progress(done, all_rows)
        except BaseException as error:  # handed on to the caller
            failed.append(error)
            stop.set()
        # The main thread ends before those that go on in the background.
        return 0 if stop.is_set() or not threading.main_thread().is_alive() else 1

    def texts(words: list[str]) -> typing.Any:
        return (ctypes.c_char_p * len(words))(*(_bytes(word) for word in words))

    asked = Batch(count, texts(keys), len(keys), table.ctypes.data, texts(names), len(names),
                  0.0 if tolerance is None else float(tolerance), int(threads), _native.progress_function(told), None, flags.ctypes.data)
    given = Case(case)

    def work() -> None:
        try:
            checked(library.dashpad_solve_batch, given._handle, ctypes.byref(asked), results.ctypes.data,
                    statuses.ctypes.data, errors.ctypes.data)
        except BaseException as error:
            failed.append(error)
        finally:
            ended.set()

    # Signals reach the main thread only while it runs Python. A join that is interrupted forgets its thread.
    threading.Thread(target=work, daemon=False).start()
    try:
        while not ended.wait(0.05):
            pass
    except BaseException:
        stop.set()
        while not ended.is_set():
            try:
                ended.wait()
            except KeyboardInterrupt:  # it is on its way
                pass
        raise
    if failed:
        raise failed[0]
    words = np.array([(library.dashpad_status_name(i) or b"").decode() for i in range(6)], dtype=object)
    found = {**{name: results[:, i] for i, name in enumerate(names)}, "status": words[statuses], "error": errors,
             **{flag: flags & bit != 0 for flag, bit in _flags_of_rows.items()}}
    return type(rows)(found, index=rows.index) if hasattr(rows, "iloc") else found


