"""run_sample.py finds what a first comment shows, and what is not so."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import run_sample

SOURCE = """// What is asked?
//
//   sample [FOLDER]
//
// Writes a.csv to c.csv, of b.txt; d.csv is none. Prints:
//
//   Peak 1 g
//     HIC 2
//
//   end

int main() {}
//   not shown
"""


class FirstComment(unittest.TestCase):
    def test_the_indented_end_is_shown(self):
        self.assertEqual(run_sample.shown_in(run_sample.first_comment(SOURCE)), ["Peak 1 g", "  HIC 2", "", "end"])

    def test_files_are_named_after_writes(self):
        self.assertEqual(run_sample.written_by(run_sample.first_comment(SOURCE)), ["a.csv", "c.csv"])
        self.assertEqual(run_sample.written_by(["// Writes a.html and", "// b.svg. Prints c.csv."]), ["a.html", "b.svg"])


class Samples(unittest.TestCase):
    def outcome_of(self, script):
        with tempfile.TemporaryDirectory() as folder:
            source, program = pathlib.Path(folder, "sample.cpp"), pathlib.Path(folder, "sample")
            source.write_text(SOURCE, encoding="utf-8")
            program.write_text("#!/bin/sh\n" + script, encoding="utf-8")
            program.chmod(0o755)
            reader = pathlib.Path(__file__).with_name("run_sample.py")
            done = subprocess.run([sys.executable, reader, program, source, folder], capture_output=True, text=True,
                                  check=False)
            return done.returncode, done.stdout

    def test_what_is_printed_and_written_passes(self):
        self.assertEqual(self.outcome_of("echo 1 | tee a.csv > c.csv; printf 'Peak 1 g\\n  HIC 2\\n\\nend\\n'")[0], 0)

    def test_other_numbers_missing_files_and_failures_are_found(self):
        code, printed = self.outcome_of("echo 1 > a.csv; printf 'Peak 1 g\\n  HIC 3\\n\\nend\\n'")
        self.assertEqual(code, 1)
        self.assertIn("not printed there:   HIC 2", printed)
        self.assertIn("not written: c.csv", printed)
        self.assertNotIn("a.csv", printed)
        self.assertIn("exit code 3", self.outcome_of("exit 3")[1])


if __name__ == "__main__":
    unittest.main()
