"""The package for Python: its numbers are those of the command, and no mistake of its user ends the interpreter."""

import copy
import doctest
import gc
import json
import math
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import dashpad
from dashpad import Case, DashpadFaults, batch, solve

sources = Path(__file__).resolve().parents[2]
command = os.environ.get("DASHPAD_COMMAND")
dashboard = sources / "examples/dashboard-20mph.toml"


def pandas_or_skip():
    try:
        import pandas
    except ImportError:
        raise unittest.SkipTest("no pandas") from None
    return pandas


def drop():
    return Case(impactor={"mass": "5 kg", "radius": "80 mm", "speed": "4 m/s"},
                pad={"thickness": "40 mm", "material": "eps-29"}, support={"type": "rigid"})


class OfTheCommand(unittest.TestCase):
    def by_command(self, *arguments):
        done = subprocess.run([command, *arguments, "--json", "-"], capture_output=True, text=True, check=False)
        return json.loads(done.stdout)

    @unittest.skipUnless(command, "no command")
    def test_every_example_has_the_bits_of_the_command(self):
        for file in sorted((sources / "examples").glob("*.toml")):
            with self.subTest(file.name):
                case = Case(file)
                found, expected = solve(case).data, self.by_command("run", str(file), "--no-intervals")
                for result in (found, expected):
                    del result["solver"]["wall_time_s"], result["program"]["commit"]
                    result.pop("blows", None)  # of a series the last is solved for
                self.assertEqual(found, expected)

    @unittest.skipUnless(command, "no command")
    def test_answers_are_those_of_the_command(self):
        name = "fmvss-201-instrument-panel"
        found = dashpad.assess(dashboard, name).data
        expected = self.by_command("assess", str(dashboard), "--standard", name)
        self.assertEqual((found["verdict"], found["criteria"]), (expected["verdict"], expected["criteria"]))
        found = dashpad.solve_for(dashboard, "pad.thickness", standard=name).data
        self.assertEqual(found["turns"], self.by_command("solve-for", "pad.thickness", str(dashboard), "--standard", name)["turns"])


class Cases(unittest.TestCase):
    def test_each_way_gives_the_same_case(self):
        text = dashboard.read_text()
        for source in (dashboard, str(dashboard), text):
            self.assertEqual(Case(source)["impactor.mass"], Case(dashboard)["impactor.mass"])
        case = drop()
        self.assertEqual(Case(case.toml)["impactor.speed"], 4)
        self.assertEqual(pickle.loads(pickle.dumps(case))["pad.thickness"], 0.04)

    def test_changes_keep_the_case_valid(self):
        case = drop()
        case["pad.thickness"] = "2 in"
        case["impactor.speed"] = np.float64(5)
        thicker = case | {"pad.thickness": 0.06, "pad.material": "vn600"}
        self.assertEqual((case["pad.thickness"], thicker["pad.thickness"], thicker["impactor.speed"]), (0.0508, 0.06, 5))
        for value in (-1, 0, math.nan, math.inf, "3 kg", "", "-3 mm", "x" * 100_000):
            with self.subTest(value=str(value)[:9]), self.assertRaises(DashpadFaults):
                case["pad.thickness"] = value
        for value in (None, True, [1], b"3 mm", 1j):
            with self.subTest(value=value), self.assertRaises(TypeError):
                case["pad.thickness"] = value
        self.assertEqual(case["pad.thickness"], 0.0508)
        with self.assertRaises(KeyError):
            case["pad.colour"]
        self.assertIn("impactor.speed", case)
        self.assertEqual(len(list(case)), len(case.units))

    def test_all_faults_come_at_once(self):
        with self.assertRaises(DashpadFaults) as told:
            Case(impactor={"mass": "5 kpg", "radius": "-80 mm", "speed": "4 m/s"},
                 pad={"thickness": "40 mm", "material": "vn601"}, support={"type": "rigid"})
        self.assertEqual([fault.key for fault in told.exception.faults], ["impactor.mass", "impactor.radius", "pad.material"])
        self.assertIn('"vn600"', str(told.exception))
        self.assertIsInstance(told.exception, ValueError)
        for bad in ("nowhere.toml", "\n[", {"impactor": {}}, {}):
            with self.subTest(bad=bad), self.assertRaises(DashpadFaults):
                Case(bad)
        for bad in (3, [1], b"x", object(), {1: 2}, {"impactor": {"mass": object()}}):
            with self.subTest(bad=bad), self.assertRaises(TypeError):
                Case(bad)
        with self.assertRaises(ValueError):
            Case("a\0b")


class Results(unittest.TestCase):
    def test_histories_outlive_their_result_and_are_not_copied(self):
        result = solve(drop())
        force = result.history["force"]
        again = result.history["force"]
        self.assertEqual(force.__array_interface__["data"], again.__array_interface__["data"])
        expected, peak = force.copy(), result.peak_acceleration
        del result, again
        gc.collect()
        [solve(drop() | {"impactor.speed": 3 + i / 10}) for i in range(10)]
        np.testing.assert_array_equal(force, expected)
        self.assertAlmostEqual(force.max() / 5, peak, delta=2e-3 * peak)
        with self.assertRaises(ValueError):
            force[0] = 1

    def test_every_figure_is_an_attribute(self):
        result = solve(dashboard)
        for name in dashpad.figures:
            self.assertIsInstance(getattr(result, name), float)
        self.assertTrue(result.met_tolerance)
        with self.assertRaises(AttributeError):
            result.colour
        for bad in (-1, math.nan, 1, 1e-12):
            with self.subTest(tolerance=bad), self.assertRaises(DashpadFaults):
                solve(dashboard, tolerance=bad)

    def test_copies_and_pickles_are_as_good(self):
        result = solve(dashboard, tolerance=1e-3)
        expected, force = result.hic15, result.history["force"].copy()
        history = copy.deepcopy(result.history)
        twins = [copy.copy(result), copy.deepcopy(result), pickle.loads(pickle.dumps(result))]
        result.__del__()
        del result
        gc.collect()
        for twin in twins[2:]:
            self.assertEqual(twin.hic15, expected)
        np.testing.assert_array_equal(history["force"], force)
        with self.assertRaises(AttributeError):
            twins[2].hic15 = 3
        answer = dashpad.assess(dashboard)
        self.assertEqual(pickle.loads(pickle.dumps(answer)).title, answer.title)
        with self.assertRaises(DashpadFaults) as caught:
            Case("no-file.toml")
        self.assertEqual(pickle.loads(pickle.dumps(caught.exception)).faults, caught.exception.faults)

    def test_notebooks_show_the_page(self):
        shown = solve(dashboard)._repr_html_()
        self.assertIn("&lt;svg", shown)
        self.assertIn("129", shown)


class Batches(unittest.TestCase):
    def test_rows_have_the_bits_of_single_cases(self):
        case, speeds = drop(), np.linspace(3, 5, 70)
        found = batch(case, {"impactor.speed": speeds, "pad.thickness": 0.05}, ["hic15", "peak_strain"])
        for i in (0, 33, 69):
            result = solve(case | {"impactor.speed": speeds[i], "pad.thickness": 0.05})
            self.assertEqual((found["hic15"][i], found["peak_strain"][i]), (result.hic15, result.peak_strain))
        self.assertEqual(set(found["status"]), {"released"})
        self.assertTrue((found["error"] < 1e-3).all())

    def test_what_is_wrong_is_told(self):
        case = drop()
        for rows, figures in (({"impactor.sped": [1]}, "hic15"), ({"impactor.speed": [1, -1]}, "hic15"),
                              ({"impactor.speed": [1, math.nan]}, "hic15"), ({"impactor.speed": [1]}, "hic16"),
                              ({"pad.material": [1]}, "hic15"), ({}, "hic15")):
            with self.subTest(rows=rows), self.assertRaises(DashpadFaults):
                batch(case, rows, figures)
        for rows in ({"impactor.speed": [[1, 2]]}, {"impactor.speed": [1, 2], "pad.thickness": [1, 2, 3]}):
            with self.subTest(rows=rows), self.assertRaises(ValueError):
                batch(case, rows)
        for rows in ([1, 2], {"impactor.speed": ["a"]}, {"impactor.speed": [1j]}, {"impactor.speed": [None]}):
            with self.subTest(rows=rows), self.assertRaises(TypeError):
                batch(case, rows)
        for threads in (-1, 10**12):
            with self.subTest(threads=threads), self.assertRaises(ValueError):
                batch(case, {"impactor.speed": [4]}, threads=threads)
        self.assertEqual(len(batch(case, {"impactor.speed": []})["hic15"]), 0)

    def test_progress_is_told_and_its_errors_are_handed_on(self):
        seen = []
        batch(drop(), {"impactor.speed": np.linspace(3, 5, 100)}, progress=lambda done, rows: seen.append((done, rows)))
        self.assertEqual(seen[-1], (100, 100))

        def fails(done, rows):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            batch(drop(), {"impactor.speed": np.linspace(3, 5, 100)}, progress=fails)

    def test_a_case_that_changes_meanwhile_changes_nothing(self):
        case, expected = drop(), batch(drop(), {"impactor.speed": np.linspace(3, 5, 500)})["hic15"]

        def change(done, rows):
            case["pad.thickness"] = 0.01 + 1e-5 * done

        np.testing.assert_array_equal(batch(case, {"impactor.speed": np.linspace(3, 5, 500)}, progress=change)["hic15"], expected)

    def test_a_case_may_change_while_others_read_it(self):
        case, failed = drop(), []

        def work(turn):
            try:
                for i in range(300):
                    if turn == 0:
                        case["pad.material"] = ("vn600", "eps-29")[i % 2]
                    case.units, case.toml
            except BaseException as error:
                failed.append(error)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failed, [])

    def test_threads_solve_at_the_same_time(self):
        found = []
        threads = [threading.Thread(target=lambda: found.append(solve(drop()).hic15)) for _ in range(8)]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        self.assertEqual(found, [solve(drop()).hic15] * 8)

    def test_rows_tell_what_was_not_tested(self):
        found = batch(drop(), {"impactor.speed": [1.0, 8.0]}, "peak_strain")
        highest = 0.1  # of the card
        np.testing.assert_array_equal(found["extrapolated_strain"], found["peak_strain"] > highest)
        self.assertTrue(found["extrapolated_rate"].all())
        self.assertFalse(found["bottomed"].any())

    def test_tables_may_be_of_pandas(self):
        pandas = pandas_or_skip()
        frame = pandas.DataFrame({"impactor.speed": pandas.array([3, 4], dtype="Float64")}, index=[7, 9])
        found = batch(drop(), frame, "hic15")
        self.assertEqual(list(found.index), [7, 9])
        self.assertEqual(found["hic15"][9], solve(drop() | {"impactor.speed": 4}).hic15)
        for rows in (frame.iloc[0], frame.astype(str), frame.assign(note="x")):
            with self.subTest(type(rows)), self.assertRaises(TypeError):
                batch(drop(), rows, "hic15")

    def test_ctrl_c_ends_it(self):
        script = ("import dashpad, numpy as np, sys\n"
                  f"case = dashpad.Case({str(dashboard)!r})\n"
                  "told = lambda done, rows: print('on its way', flush=True)\n"
                  "dashpad.batch(case, {'impactor.speed': np.linspace(5, 9, 1_000_000)}, progress=told)\n")
        running = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        running.stdout.readline()
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=120)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertEqual(running.returncode, -signal.SIGINT)  # and no abort


class Questions(unittest.TestCase):
    def test_what_is_wrong_is_told(self):
        case = drop()
        for wrong, ask in (
            (TypeError, lambda: dashpad.assess(case, 3)),
            (TypeError, lambda: dashpad.assess(case, "en-1078", colour=3)),
            (TypeError, lambda: dashpad.solve_for(case, 3, until="hic15 <= 700")),
            (ValueError, lambda: dashpad.assess(case, "en-1078", mass=math.nan)),
            (ValueError, lambda: dashpad.assess(case, "en-1078", units="furlong")),
            (DashpadFaults, lambda: dashpad.assess(case, "en 1078")),
            (DashpadFaults, lambda: dashpad.assess(case, "en-1078", mass=-1)),
            (DashpadFaults, lambda: dashpad.solve_for(case, "pad.thickness")),
            (DashpadFaults, lambda: dashpad.solve_for(case, "pad.thickness", until="hic15")),
            (DashpadFaults, lambda: dashpad.solve_for(case, "pad.colour", until="hic15 <= 700")),
        ):
            with self.assertRaises(wrong):
                ask()

    def test_processes_may_fork(self):
        code = ("import dashpad, multiprocessing\n"
                f"case = dashpad.Case({str(dashboard)!r})\n"
                "rows = {'impactor.speed': [5.0 + i / 50 for i in range(100)]}\n"
                "def total(_): return float(dashpad.batch(case, rows)['hic15'].sum())\n"
                "expected = total(0)\n"
                "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
                "    assert pool.map_async(total, range(2)).get(timeout=120) == [expected] * 2\n")
        subprocess.run([sys.executable, "-c", code], check=True)


class Documents(unittest.TestCase):
    def test_the_example_runs(self):
        text = (sources / "docs/python.md").read_text()
        example = text.split("```python\n")[1].split("```")[0]
        done = subprocess.run([sys.executable, "-c", example], cwd=sources, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Passes: peak acceleration", done.stdout)


def load_tests(loader, tests, pattern):
    for module in ("dashpad", "dashpad._case", "dashpad._solve"):
        tests.addTests(doctest.DocTestSuite(module))
    return tests


if __name__ == "__main__":
    unittest.main()
