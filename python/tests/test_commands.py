"""What the package asks the command: its data is that of the command, and what is wrong is told as exceptions."""

import csv
import doctest
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import dashpad
from dashpad import Case, DashpadFaults, _command, _native

sources = Path(__file__).resolve().parents[2]
examples = sources / "examples"
measured = examples / "pulses/synthetic-helmet-pad.csv"
helmet = examples / "helmet-pad-10fps.toml"
tests_of_foam = [examples / "tutorial" / f"epp-{name}.csv" for name in ("slow", "fast")]
time_of_sine = np.linspace(0, 0.02, 201)
half_sine = (time_of_sine, 600 * np.sin(np.pi * time_of_sine / 0.02))


def by_command(*words):
    done = subprocess.run([_native.command_file, *map(str, words), "--json", "-"], capture_output=True, text=True, check=False,
                          env=_command._environment())
    data = json.loads(done.stdout)
    data.get("program", {}).pop("commit", None)
    return data


def without_commit(answer):
    data = dict(answer.data)
    data["program"] = {name: value for name, value in data.get("program", {}).items() if name != "commit"}
    return data


class Answers(unittest.TestCase):
    def test_data_is_that_of_the_command(self):
        drops = examples / "drops/mat-50mm.csv"
        for answer, words in (
            (dashpad.pulse(measured, filter="CFC1000", drop_height="1.5 m"),
             ("pulse", measured, "--filter", "CFC1000", "--drop-height", "1.5 m")),
            (dashpad.material_test("eps-29", rate="10", stress_limit=["50 kPa", "100 kPa"]),
             ("material-test", "eps-29", "--rate", "10", "--stress-limit", "50 kPa,100 kPa")),
            (dashpad.fall_height(drops, standard="en-1177"), ("fall-height", drops, "--standard", "en-1177")),
        ):
            with self.subTest(words[0]):
                self.assertEqual(without_commit(answer), {"program": {}, **by_command(*words)})

    def test_a_case_is_compared_with_a_pulse(self):
        of_file = dashpad.compare(helmet, measured)
        self.assertIn("measured", of_file.title)
        times, values = np.loadtxt(measured, delimiter=",", comments="#", skiprows=6, unpack=True)
        of_arrays = dashpad.compare(Case(helmet), (times / 1e3, values * 9.80665))
        self.assertEqual(of_arrays.title, of_file.title)
        self.assertIn("1984", dashpad.compare(examples / "dashboard-20mph.toml").title)

    def test_a_pulse_of_arrays_is_called_the_pulse(self):
        answer = dashpad.pulse(half_sine, standard="en-1177")
        self.assertEqual(answer.data["source"]["file"], "the pulse")
        self.assertNotIn(tempfile.gettempdir(), answer.page)
        self.assertEqual(dashpad.pulse({"time": half_sine[0], "acceleration": half_sine[1]}).data["figures"],
                         dashpad.pulse(half_sine).data["figures"])
        self.assertAlmostEqual(answer.data["figures"]["peak_acceleration"]["value_g"], 600 / 9.80665)

    def test_pages_are_saved_once(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "foam.html")
            dashpad.material_test("vn600").save(file)
            self.assertIn("<svg", file.read_text(encoding="utf-8"))
            with self.assertRaises(FileExistsError):
                dashpad.assess(helmet).save(file)

    def test_what_is_wrong_is_told(self):
        case = Case(helmet)
        short, silent = (half_sine[0], half_sine[1][:-1]), (half_sine[0], np.full(201, np.nan))
        for error, ask in (
            (DashpadFaults, lambda: dashpad.pulse("no-file.csv")),
            (DashpadFaults, lambda: dashpad.pulse(silent)),
            (DashpadFaults, lambda: dashpad.sensitivity(case, "peak")),
            (DashpadFaults, lambda: dashpad.material_test("-x")),
            (DashpadFaults, lambda: dashpad.material_test("eps-29", strain="abc")),
            (DashpadFaults, lambda: dashpad.fall_height(case | {"impactor.mass": "4.6 kg"}, standard="none")),
            (TypeError, lambda: dashpad.pulse(measured, colour="red")),
            (TypeError, lambda: dashpad.pulse(measured, filter=object())),
            (ValueError, lambda: dashpad.pulse(short)),
            (ValueError, lambda: dashpad.pulse({"t": half_sine[0], "a": half_sine[1]})),
            (TypeError, lambda: dashpad.pulse(("a", "b"))),
            (TypeError, lambda: dashpad.pulse(3)),
            (TypeError, lambda: dashpad.pulse((half_sine[0], half_sine[1] * 1j))),
            (TypeError, lambda: dashpad.pulse(half_sine, measured)),
            (TypeError, lambda: dashpad.pulse(half_sine, help=True)),
            (OSError, lambda: dashpad.Store(sources)),
            (FileNotFoundError, lambda: dashpad.Store("no-store.db")),
            (ValueError, lambda: dashpad.Store(helmet)),
            (TypeError, lambda: dashpad.study(3, "store.db")),
        ):
            with self.subTest(error.__name__), self.assertRaises(error):
                ask()
        with self.assertRaises(DashpadFaults) as caught:
            dashpad.pulse("no-file.csv")
        (fault,) = caught.exception.faults
        self.assertEqual((fault.file, fault.key, fault.rule), ("no-file.csv", "", "no such file"))

    def test_faults_have_file_line_key_and_value(self):
        with self.assertRaises(DashpadFaults) as caught:
            dashpad.fall_height({"drop_height [m]": [1, 2], "gmax": ["a", 3], "hic": [3, 4]})
        (fault,) = caught.exception.faults
        self.assertEqual((fault.file, fault.line, fault.key, fault.value), ("the drops", 2, "gmax", "a"))
        self.assertTrue(fault.rule.startswith("a pure number must start with a number"))

    def test_drops_are_a_file_a_dictionary_or_a_data_frame(self):
        file = examples / "drops/mat-50mm.csv"
        with open(file, encoding="utf-8") as lines:
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        columns = {key: [row[key] for row in rows] for key in rows[0]}
        self.assertEqual(dashpad.fall_height(columns).data["answer"], by_command("fall-height", file)["answer"])
        with self.assertRaises(ValueError):
            dashpad.fall_height({"drop_height [m]": [1, 2], "gmax": [3]})


class Fits(unittest.TestCase):
    def test_a_fitted_foam_is_the_material_of_a_case(self):
        foam = dashpad.fit(*tests_of_foam, thickness="25 mm", area="25 cm2")
        case = Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
                    pad={"thickness": "40 mm", "material": foam}, support={"type": "rigid"})
        other = case | {"pad.material": "eps-29"}
        other["pad.material"] = foam
        self.assertEqual(dashpad.solve(case).hic15, dashpad.solve(other).hic15)
        with self.assertRaises(ValueError):
            other["pad.material"] = dashpad.assess(helmet)

    def test_tests_become_a_foam(self):
        found = dashpad.fit(*tests_of_foam, thickness="25 mm", area="25 cm2")
        self.assertTrue(found.title.startswith("Proposed: law foam"))
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "epp.toml").write_text(found.card)
            self.assertGreater(dashpad.solve(Case(helmet) | {"pad.material": str(Path(folder) / "epp.toml")}).hic15, 0)
        self.assertTrue(found.data["converged"])
        self.assertIn(found.data["title"], found.card)

    def test_a_fit_file_is_fitted(self):
        found = dashpad.fit(examples / "fits/vn600.toml")
        self.assertEqual(found.data["unknowns"], by_command("fit", examples / "fits/vn600.toml")["unknowns"])

    def test_what_is_wrong_is_told(self):
        for wrong in ((), ("/nowhere.csv",), (__file__,), tests_of_foam[:1]):
            with self.assertRaises(DashpadFaults):
                dashpad.fit(*wrong)


class Studies(unittest.TestCase):
    tables = {"case": Case(helmet), "responses": ["hic15", "peak_strain"],
              "factors": {"impactor.speed": {"from": "2 m/s", "to": "4 m/s", "count": 5}}}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name, "study.db")

    def test_rows_are_those_of_single_cases(self):
        store = dashpad.study(self.tables, self.file)
        rows = store.rows()
        self.assertEqual((len(store), store.units["impactor.speed"]), (5, "m/s"))
        np.testing.assert_allclose(rows["impactor.speed"], np.linspace(2, 4, 5))
        found = dashpad.batch(helmet, {"impactor.speed": rows["impactor.speed"]}, ["hic15", "peak_strain"],
                              tolerance=1e-3)
        for name in ("hic15", "peak_strain", "error"):
            np.testing.assert_array_equal(rows[name], found[name])
        self.assertIn("HIC15", store.summary(limit="hic15 > 100").title)

    def test_the_same_call_goes_on(self):
        dashpad.study(self.tables, self.file)
        before = self.file.stat().st_mtime_ns
        self.assertEqual(len(dashpad.study(self.tables, self.file)), 5)
        self.assertLessEqual(self.file.stat().st_mtime_ns - before, 10**9)
        with self.assertRaises(DashpadFaults):
            dashpad.study({**self.tables, "responses": ["hic36"]}, self.file)

    def test_materials_have_their_names(self):
        names = {"pad.material": {"values": ["eps-29", "vn600"]}}
        rows = dashpad.study({**self.tables, "factors": names}, self.file).rows()
        self.assertEqual(list(rows["pad.material"]), ["eps-29", "vn600"])

    def test_ctrl_c_loses_no_row(self):
        code = ("import sys, dashpad; sys.path.insert(0, sys.argv[1]); import test_commands as t\n"
                "many = {**t.Studies.tables, 'factors': {'impactor.speed': {'from': '2 m/s', 'to': '4 m/s', 'count': 200_000}}}\n"
                "dashpad.study(many, sys.argv[2])")
        # In a session of its own, as that of a notebook, whose interrupt reaches Python alone.
        process = subprocess.Popen([sys.executable, "-c", code, str(Path(__file__).parent), str(self.file)],
                                   stderr=subprocess.PIPE, start_new_session=True,
                                   env={**os.environ, "PYTHONPATH": str(Path(dashpad.__file__).parents[1])})
        for _ in range(200):
            time.sleep(0.1)
            if self.file.exists() and self.rows() > 0:
                break
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
        self.assertIn(b"KeyboardInterrupt", err)
        self.assertTrue(0 < self.rows() < 200_000)

    def rows(self):
        try:
            return len(dashpad.Store(self.file))
        except (ValueError, OSError):
            return 0


def load_tests(loader, tests, pattern):
    tests.addTests(doctest.DocTestSuite("dashpad._command"))
    return tests


if __name__ == "__main__":
    os.chdir(tempfile.gettempdir())
    unittest.main()
