"""run_examples.py finds what it is there for: lines that are not printed, are out of order, or are left out unmarked."""

import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import run_examples

PRINTED = ["Peak 1 g", "", "a  2", "b  3", "end"]


class ShownLines(unittest.TestCase):
    def missing(self, *shown):
        return run_examples.missing_from(PRINTED, list(shown))

    def test_what_is_printed_passes(self):
        self.assertIsNone(self.missing(*PRINTED))
        self.assertIsNone(self.missing("Peak 1 g", "..."))
        self.assertIsNone(self.missing("...", "a  2", "b  3", "..."))
        self.assertIsNone(self.missing("...", "a  2", "...", "end"))
        self.assertIsNone(self.missing("..."))

    def test_another_number_is_found(self):
        self.assertEqual(self.missing("Peak 1 g", "", "a  2", "b  4", "end"), "b  4")
        self.assertEqual(self.missing("...", "a  2", "b  4", "..."), "b  4")
        self.assertEqual(self.missing("...", "b  3", "...", "a  2", "..."), "a  2")

    def test_what_is_left_out_must_be_marked(self):
        self.assertEqual(self.missing("Peak 1 g", "a  2", "..."), "a  2")
        self.assertEqual(self.missing("a  2", "..."), "a  2")
        self.assertIn("more is printed", self.missing("Peak 1 g", "...", "b  3"))
        self.assertIn("more is printed", self.missing("...", "a  2", "b  3"))
        self.assertIn("more is printed", self.missing())


class Documents(unittest.TestCase):
    def outcome_of(self, text):
        """Of a project whose command prints its arguments and, in place of them, a file that exists."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "examples").mkdir()
            (root / "page.md").write_text(textwrap.dedent(text), encoding="utf-8")
            command = root / "command"
            command.write_text('#!/bin/sh\n[ "$1" = fail ] && echo "1 error" && exit 2\n[ -f "$1" ] && exec cat "$1"\necho "$@"\n')
            command.chmod(0o755)
            program = pathlib.Path(__file__).with_name("run_examples.py")
            done = subprocess.run([sys.executable, program, command, root, "page.md"], capture_output=True, text=True,
                                  check=False)
            return done.returncode, done.stdout

    def test_files_are_written_and_commands_run(self):
        self.assertEqual(self.outcome_of("""
            ```toml a.toml
            x = 1
            ```
            ```console
            $ dashpad a.toml
            x = 1
            $ dashpad one \\
              two
            one two
            $ ls nowhere
            ```
            """)[0], 0)

    def test_faults_are_told_with_their_line(self):
        code, out = self.outcome_of("```console\n$ dashpad one\ntwo\n```\n")
        self.assertEqual(code, 1)
        self.assertIn("page.md:2: dashpad one\n  shown, not printed there: two", out)
        self.assertIn("exit code 2", self.outcome_of("```console\n$ dashpad fail\n...\n```\n")[1])
        self.assertIn("exit code 0", self.outcome_of("```console\n$ dashpad\n1 error\n```\n")[1])
        self.assertEqual(self.outcome_of("```console\n$ dashpad fail\n1 error\n```\n")[0], 0)
        self.assertEqual(self.outcome_of("no command\n")[0], 1)


if __name__ == "__main__":
    unittest.main()
