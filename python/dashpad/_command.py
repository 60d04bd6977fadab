"""What the command answers, in a process of its own: pulses, tests of foams, fall heights, sensitivities and studies."""

from __future__ import annotations

import contextlib
import csv
import html
import io
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import typing
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from . import _native
from ._answer import Answer
from ._case import Case, toml_of_tables
from ._columns import column_of
from ._native import DashpadFaults, Fault

File = typing.Union[str, "os.PathLike[str]"]
Pulse = typing.Union[File, "tuple[typing.Any, typing.Any]", "Mapping[str, typing.Any]"]

_invalid_input = 2


def main() -> None:
    """The command itself, which an installed package puts on the path."""
    os.execve(_native.command_file, ["dashpad", *sys.argv[1:]], _environment())


def _environment() -> dict[str, str]:
    own = {"DASHPAD_MATERIALS": _native.materials, "DASHPAD_STANDARDS": _native.standards}
    # A wheel has the libraries of the command beside its modules.
    if (_native.here / "bin").exists():
        own["LD_LIBRARY_PATH"] = os.pathsep.join(filter(None, [str(_native.here), os.environ.get("LD_LIBRARY_PATH")]))
    return {**os.environ, **own}


def _words_of(options: Mapping[str, typing.Any]) -> list[str]:
    """``drop_height="1.5 m"`` as ``--drop-height=1.5 m``; True as an option without a value, a list as several."""
    words = []
    for name, value in options.items():
        if name in ("help", "json", "report", "force"):
            raise TypeError(f"{name} is an option of the command alone")
        option = "--" + name.rstrip("_").replace("_", "-")
        if value is None or value is False or value == "":
            continue
        if value is True:
            words.append(option)
            continue
        for each in value if isinstance(value, (list, tuple)) else [value]:
            if not isinstance(each, (str, int, float, os.PathLike)):
                raise TypeError(f"{name} is a text or a number, not {type(each).__name__}")
            words.append(f"{option}={os.fspath(each) if isinstance(each, os.PathLike) else each}")
    return words


def _faults_of(text: str) -> list[Fault]:
    """Each fault is a line, which lines that begin with a blank continue."""
    lines: list[str] = []
    for line in text.rstrip("\n").split("\n"):
        if line.startswith(" ") and lines:
            lines[-1] += "\n" + line
        elif line and not re.fullmatch(r"\d+ errors?; nothing was run|Run with --help for more information\.", line):
            lines.append(line)
    faults = []
    for line in lines:
        # As the command writes a fault: file:line: key = value: rule, each but the last where there is one.
        parts = re.match(r"((?P<file>the \w+|[^:\s]+\.\w+)(:(?P<line>\d+))?: )?((?P<key>[^\s:]+)( = (?P<value>[^\n]+?))?: )?", line)
        assert parts  # all of it is optional
        faults.append(Fault(file=parts["file"] or "", line=int(parts["line"] or 0), key=parts["key"] or "",
                            value=parts["value"] or "", rule=line[parts.end():], text=line))
    return faults


def _run(words: Sequence[str]) -> tuple[int, str, str]:
    """Exit code, standard output and standard error; Ctrl-C ends the command in its own orderly way."""
    process = subprocess.Popen([str(_native.command_file), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, encoding="utf-8", errors="replace", env=_environment())
    try:
        out, err = process.communicate()
    except BaseException:
        process.send_signal(signal.SIGINT)
        process.communicate()
        raise
    return process.returncode, out, err


def _checked(words: Sequence[str], named: Mapping[str, str]) -> str:
    """What the command prints as data. `named`: what stands for a temporary file in its faults."""
    code, out, err = _run(words)
    for file, name in named.items():
        err = err.replace(file, name)
    if unknown := re.match(r"The following arguments? .* not expected: .*?(--\w[\w-]*)", err):
        raise TypeError(f"dashpad {words[0]} has no option {unknown[1]}")
    if code == _invalid_input:
        raise DashpadFaults(_faults_of(err))
    # 3 and 4 are answers: not reliable, and beyond a limit.
    if code not in (0, 3, 4):
        raise OSError(err.strip() or f"dashpad ended with {code}")
    return out


def _with_page(words: Sequence[str], files: Sequence[str], named: Mapping[str, str]) -> tuple[str, str]:
    """What the command prints as data, and its page. `named`: what stands for a temporary file in all texts."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "page.html")
        data = _checked([*words, f"--report={file}", "--", *files], named)
        page = file.read_text(encoding="utf-8")
    for temporary, name in named.items():
        data, page = data.replace(temporary, name), page.replace(temporary, name)
    return data, page


def _answer(command: str, files: Sequence[str], options: Mapping[str, typing.Any], named: Mapping[str, str]) -> Answer:
    data, page = _with_page([*command.split(), *_words_of(options), "--json=-"], files, named)
    title = re.search("<h1[^>]*>(.*?)</h1>", page, re.DOTALL)
    # Without the sign of its tone.
    words = re.sub('<span class="sign[^>]*>[^<]*</span>|<[^>]*>', "", title[1]) if title else ""
    return Answer(" ".join(html.unescape(words).split()), json.loads(data), page)


def page_of(command: str, words: Sequence[str], options: Mapping[str, typing.Any], case: Case | None = None) -> str:
    """The page that the command makes of a case; after `words` of its own."""
    with _as_files(**({"case_toml": case.toml} if case is not None else {})) as files:
        named = {file: "the case" for file in files.values()}
        return _with_page([command, *_words_of(options)], [*words, *files.values()], named)[1]


@contextlib.contextmanager
def _as_files(**given: str) -> Iterator[dict[str, str]]:
    """Texts as files of a folder that goes; the name of each argument is that of its file, but for the last "_"."""
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        for name, text in given.items():
            path = pathlib.Path(folder, name.replace("_", "."))
            path.write_text(text, encoding="utf-8")
            files[name] = str(path)
        yield files


def _pulse_text(pulse: typing.Any) -> str:
    names = ("time", "acceleration")
    if hasattr(pulse, "keys"):
        if not all(name in pulse.keys() for name in names):
            raise ValueError(f'a pulse needs the columns "time" and "acceleration", not {", ".join(map(str, pulse.keys()))}')
        pulse = (pulse["time"], pulse["acceleration"])
    if not isinstance(pulse, (tuple, list)) or len(pulse) != 2:
        raise TypeError(f"a pulse is a file or a pair of arrays, times and accelerations, not {type(pulse).__name__}")
    columns = [column_of(name, each) for name, each in zip(names, pulse)]
    if columns[0].shape != columns[1].shape:
        raise ValueError(f"times and accelerations are arrays of one length, not {len(columns[0])} and {len(columns[1])}")
    rows = (f"{t!r},{a!r}\n" for t, a in zip(columns[0].tolist(), columns[1].tolist()))
    return "time_s,acceleration_m_per_s2\n" + "".join(rows)


def pulse(measured: Pulse, *more: File, standard: str = "", **options: typing.Any) -> Answer:
    """The injury figures of a measured pulse, as ``dashpad pulse``.

    ``measured`` is a table (CSV) or an ISO-MME test, with ``more`` files of the same drop series; or a pair of arrays, times
    in s and accelerations in m/s2; or a mapping or data frame with the columns "time" and "acceleration". ``standard``
    compares the figures with its limits. Further ``options`` are those of the command, texts with units:
    ``filter="CFC1000"``, ``drop_height="1.5 m"``, ``zero="auto"``, ``from_="10 ms"``.

    >>> import numpy as np
    >>> time = np.linspace(0, 0.02, 201)
    >>> half_sine = 600 * np.sin(np.pi * time / 0.02)
    >>> found = pulse((time, half_sine))
    >>> print(found.title)
    Peak 61.2 g, HIC15 243
    """
    options = {"standard": standard, **options}
    if isinstance(measured, (str, os.PathLike)):
        return _answer("pulse", [os.fspath(file) for file in (measured, *more)], options, {})
    if more:
        raise TypeError("more than one pulse needs files")
    with _as_files(pulse_csv=_pulse_text(measured)) as files:
        return _answer("pulse", [files["pulse_csv"]], options, {files["pulse_csv"]: "the pulse"})


def compare(case: typing.Any, measured: Pulse | None = None, **options: typing.Any) -> Answer:
    """A case beside a measured pulse (as :func:`pulse` takes it) or, without one, beside the program of 1984: as ``dashpad compare``.

    Further ``options`` are those of the command: ``align="peak"``, ``filter="CFC1000"``.
    """
    given = {"case_toml": Case(case).toml}
    if isinstance(measured, (str, os.PathLike)):
        options["pulse"] = measured
    elif measured is not None:
        given["pulse_csv"] = _pulse_text(measured)
    with _as_files(**given) as files:
        options.setdefault("pulse", files.get("pulse_csv"))
        names = {"case_toml": "the case", "pulse_csv": "the pulse"}
        return _answer("compare", [files["case_toml"]], options, {file: names[each] for each, file in files.items()})


def material_test(material: File, test: str = "constant-rate", **options: typing.Any) -> Answer:
    """A laboratory test of a foam, as ``dashpad material-test``: of a card supplied, by its name, or of a card file.

    ``test`` is "constant-rate", "parabolic", "relaxation", "creep", "cyclic" or "history". Further ``options`` are those of
    the command, texts with units: ``rate="1,100"`` (1/s), ``strain=0.5``, ``hold="2 s"``, ``stress="50 kPa"``,
    ``stress_limit="50 kPa,100 kPa"``, ``history="strains.csv"``.

    >>> print(material_test("eps-29", rate="10").title)  # doctest: +ELLIPSIS
    Best used up to ...
    """
    return _answer("material-test", [os.fspath(material)], {"test": test, **options}, {})


def fit(*tests: File, rate: typing.Any = None, **options: typing.Any) -> Answer:
    """A foam from the tables of compression tests (CSV), as ``dashpad fit --auto`` makes it, or by a fit file (TOML).

    ``card`` is the material card, None if the fit does not converge; a case takes the answer as its ``material``. ``rate``,
    where the tables lack it, is one text for all of them or a list of one for each: ``rate="0.01 1/s"``. Further
    ``options`` are those of the command, texts with units: ``thickness="25 mm"``, ``area="25 cm2"``, ``strain="e"``.
    """
    files = [os.fspath(file) for file in tests]
    if [pathlib.Path(file).suffix for file in files] != [".toml"]:
        options["auto"] = True
    rates = [rate] * len(files) if isinstance(rate, str) else rate
    with tempfile.TemporaryDirectory() as folder:
        card = pathlib.Path(folder, "card.toml")
        found = _answer("fit", files, {**options, "rate": rates, "output": card}, {str(card): "the card"})
        found.card = card.read_text(encoding="utf-8") if card.exists() else None
    return found


def _drops_text(drops: typing.Any) -> str:
    """A table of drops as CSV: a column for each key, with its unit as in "drop_height [m]"."""
    columns = {str(key): list(drops[key]) for key in drops.keys()}
    if len({len(column) for column in columns.values()}) > 1:
        raise ValueError(f"columns of the drops have different lengths: {', '.join(f'{key} {len(column)}' for key, column in columns.items())}")
    written = io.StringIO()
    csv.writer(written).writerows([list(columns), *zip(*columns.values())])
    return written.getvalue()


def fall_height(*given: typing.Any, standard: str = "", **options: typing.Any) -> Answer:
    """The critical fall height of a surface, as ``dashpad fall-height``: from a table of drops (a file, or a dictionary or data
    frame with its columns, such as "position", "drop_height [m]", "gmax", "hic"), from a case, or from both side by side.

    ``standard`` has the limits (default: "en-1177"). Further ``options`` are those of the command: ``between="1 m..3 m"``
    for the heights to search with a case, ``about="Operator: ..."``.

    >>> drops = {"drop_height [m]": [1.2, 1.5, 1.8, 2.1], "gmax": [89.2, 118, 157, 214], "hic": [319, 519, 806, 1290]}
    >>> print(fall_height(drops).title)  # doctest: +ELLIPSIS
    Critical fall height 1.9... m ...
    """
    options = {"standard": standard, **options}
    files, named = [], {}
    with contextlib.ExitStack() as kept:
        for each in given:
            if isinstance(each, (str, os.PathLike)):
                files.append(os.fspath(each))
                continue
            is_table = hasattr(each, "keys") and any(str(key).startswith("drop_height") for key in each.keys())
            text = {"drops_csv": _drops_text(each)} if is_table else {"case_toml": Case(each).toml}
            [file] = kept.enter_context(_as_files(**text)).values()
            files.append(file)
            named[file] = "the drops" if is_table else "the case"
        answer = _answer("fall-height", files, options, named)
    return answer


def sensitivity(case: typing.Any, figure: str = "peak_acceleration", **options: typing.Any) -> Answer:
    """Which numbers of a case a figure hangs on, as ``dashpad sensitivity``: by how many per cent each figure changes if a
    number grows by 1 %, with the numerical error, and what is uncertain of foam and model.

    >>> case = Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
    ...             pad={"thickness": "40 mm", "material": "eps-29"}, support={"type": "rigid"})
    >>> print(sensitivity(case).title)  # doctest: +ELLIPSIS
    Peak acceleration depends most on the impact speed (1 % more: +1.42 %), then on the thickness of the pad ...
    """
    with _as_files(case_toml=Case(case).toml) as files:
        named = {files["case_toml"]: "the case"}
        return _answer("sensitivity", [files["case_toml"]], {"figure": figure, **options}, named)


class Store:
    """The rows of a study in its file, an SQLite database. ``units`` has the SI unit of each column, by its key."""

    def __init__(self, file: File):
        self.file = os.path.abspath(file)
        if not pathlib.Path(self.file).exists():
            raise FileNotFoundError(f"{self.file}: no such store")
        self.units = {key: unit for table in ("factors", "responses") for key, unit in self._read(
            f"SELECT {'key' if table == 'factors' else 'name'}, unit FROM {table} ORDER BY position")}

    def _read(self, query: str) -> list[typing.Any]:
        import sqlite3

        try:
            with contextlib.closing(sqlite3.connect(f"{pathlib.Path(self.file).as_uri()}?mode=ro", uri=True)) as store:
                return store.execute(query).fetchall()
        except sqlite3.OperationalError as error:
            raise OSError(f"{self.file} cannot be read: {error}") from error
        except sqlite3.DatabaseError as error:
            raise ValueError(f"{self.file} is not the store of a study: {error}") from error

    def __len__(self) -> int:
        return int(self._read("SELECT count(*) FROM samples")[0][0])

    def rows(self) -> dict[str, np.ndarray[typing.Any, typing.Any]]:
        """The rows in their order: an array for each factor and each response, in SI, NaN where an impact does not have it,
        with "status", "error" and "bottomed"; materials by their names. ``pandas.DataFrame(store.rows())`` makes a data frame."""
        keys = list(self.units)
        columns = ", ".join('"' + key.replace('"', '""') + '"' for key in ["status", "bottomed", "error", *keys])
        found = list(zip(*self._read(f"SELECT {columns} FROM samples ORDER BY row"))) or [()] * (len(keys) + 3)
        status, bottomed, error, *numbers = found
        rows = {key: np.array(column, dtype=float) for key, column in zip(keys, numbers)}
        materials = dict(self._read("SELECT number, name FROM materials"))
        for key in keys:
            if key.endswith(".material") or key == "pad.material":
                rows[key] = np.array([materials.get(int(number)) for number in rows[key]], dtype=object)
        return {**rows, "status": np.array(status, dtype=object), "error": np.array(error, dtype=float),
                "bottomed": np.array(bottomed, dtype=bool)}

    def summary(self, **options: typing.Any) -> Answer:
        """Distributions, probabilities and sensitivities, as ``dashpad study summary``: ``limit="hic15 > 1000"``,
        ``standard="en-1177"``, ``response=["hic15", "peak_strain"]``."""
        return _answer("study summary", [self.file], options, {})

    def __repr__(self) -> str:
        return f"<dashpad.Store {self.file}: {len(self)} rows>"


def study(given: typing.Any, store: File, *, threads: int | None = None, extend: bool = False) -> Store:
    """Solves the rows of a study and keeps them in a store, as ``dashpad study --out``.

    ``given`` is a study file, or a dictionary of its tables, whose "case" may be a :class:`Case`. The same call goes on with
    a study that was stopped by Ctrl-C or a crash: no row is lost and none computed twice. For a table of your own rows
    in memory there is :func:`batch`.

    >>> import tempfile
    >>> case = Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
    ...             pad={"thickness": "40 mm", "material": "eps-29"}, support={"type": "rigid"})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     store = study({"case": case, "samples": 64, "responses": ["hic15", "peak_strain"], "factors": {
    ...         "pad.thickness": {"values": ["30 mm", "40 mm"]},
    ...         "impactor.speed": {"distribution": "normal", "mean": "4 m/s", "deviation": "0.2 m/s"},
    ...     }}, folder + "/study.db")
    ...     len(store), sorted(store.rows())[:3]
    (128, ['bottomed', 'error', 'hic15'])
    """
    options = {"out": os.fspath(store), "threads": threads, "extend": extend, "quiet": True}
    if isinstance(given, (str, os.PathLike)):
        _checked(["study", *_words_of(options), "--", os.fspath(given)], {})
        return Store(store)
    if not isinstance(given, Mapping):
        raise TypeError(f"a study is a file or a dictionary, not {type(given).__name__}")
    tables = dict(given)
    case = tables.get("case")
    own = {}
    if isinstance(case, (Case, Mapping)):
        own["case_toml"] = Case(case).toml
        tables["case"] = "case.toml"
    elif case is not None:
        tables["case"] = os.path.abspath(os.fspath(case))
    with _as_files(study_toml=toml_of_tables(tables), **own) as files:
        named = {files["study_toml"]: "the study", files.get("case_toml", "case.toml"): "the case"}
        _checked(["study", *_words_of(options), "--", files["study_toml"]], named)
    return Store(store)
