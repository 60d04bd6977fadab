"""Manual pages and completions have every option of --help, and programs that read them find nothing wrong.

    help_files.py COMMAND FOLDER      FOLDER as dashpad-help wrote it

Without man, zsh or fish, what they would read is left out.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

COMMAND, FOLDER = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]


def output(*words, **options):
    return subprocess.run(words, check=True, capture_output=True, text=True, **options).stdout


def read(name):
    return (FOLDER / name).read_text(encoding="utf-8")


def commands():
    """The words of each command, and what its --help says."""
    found, left = {}, [()]
    while left:
        words = left.pop()
        found[words] = text = output(COMMAND, *words, "--help")
        body = text.split("\nExamples:")[0].split("\nStart here:")[0]
        groups = re.findall(r"^(?!Positionals|Options|With|Exit)[A-Z][^\n]*:\n((?:  .*\n)+)", body, re.M)
        left += [(*words, name) for group in groups for name in re.findall(r"^  ([a-z][\w-]*) ", group, re.M)]
    return found


COMMANDS = commands()


def options(words):
    """Every option as (names, allowed values)."""
    found = re.findall(r"^  (--?[\w,-]+)(.*)$", COMMANDS[words].split("\nExamples:")[0], re.M)
    for names, rest in found:
        allowed = re.search(r":\{([^}]*)\}", rest)
        yield names.split(","), allowed.group(1).split(",") if allowed else []


def completed_by_bash(line):
    """The last word of the line is the one to complete; "=" stands by itself, as bash parts it."""
    words = ["dashpad", *line.split(" ")]
    script = f"""source {FOLDER}/dashpad.bash
        COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _dashpad {COMMAND}; printf '%s\\n' "${{COMPREPLY[@]}}" """
    return set(output("bash", "-c", script, "bash", *words).split())


def names_in(folder):
    return {path.stem for path in (ROOT / folder).glob("*.toml")}


class Manual(unittest.TestCase):
    def test_has_a_page_for_each_command(self):
        self.assertGreater(len(COMMANDS), 25)
        self.assertEqual({path.name for path in (FOLDER / "man1").iterdir()},
                         {"-".join(("dashpad", *words)) + ".1" for words in COMMANDS})

    def test_has_every_option_and_every_word_of_the_closing_text(self):
        for words, text in COMMANDS.items():
            page = read("man1/" + "-".join(("dashpad", *words)) + ".1").replace("\\-", "-").replace("\\e", "\\")
            for names, _ in options(words):
                self.assertIn(f".TP\n\\fB{','.join(names)}\\fR", page, words)
            for line in re.split("\nExamples:|\nStart here:", text)[1].splitlines():
                self.assertIn(line.strip().removeprefix("Exit codes:").strip(), page, words)

    @unittest.skipUnless(shutil.which("man"), "no man")
    def test_is_read_by_man_without_warnings(self):
        for page in (FOLDER / "man1").iterdir():
            read_by = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], check=True,
                                     capture_output=True, text=True, env={**os.environ, "MANWIDTH": "80"})
            self.assertEqual(read_by.stderr, "", page)


class Bash(unittest.TestCase):
    def test_completes_every_option_and_its_values(self):
        for words in COMMANDS:
            self.assertEqual(completed_by_bash(" ".join((*words, "-"))),
                             {name for names, _ in options(words) for name in names})
            for names, allowed in options(words):
                if allowed:
                    for name in names:
                        self.assertEqual(completed_by_bash(" ".join((*words, name, ""))), set(allowed))

    def test_completes_subcommands(self):
        self.assertEqual(completed_by_bash(""), {words[0] for words in COMMANDS if len(words) == 1})
        self.assertEqual(completed_by_bash("so"), {"solve-for"})
        self.assertEqual(completed_by_bash("study su"), {"summary"})

    def test_completes_names(self):
        self.assertEqual(completed_by_bash("material-test "), names_in("materials"))
        self.assertEqual(completed_by_bash("materials vn"), {"vn600"})
        self.assertEqual(completed_by_bash("standards "), names_in("standards"))
        self.assertEqual(completed_by_bash("assess case.toml --standard en-10"), {"en-1078"})

    def test_completes_behind_an_equals_sign(self):
        self.assertEqual(completed_by_bash("run case.toml --units = e"), {"engineering-metric"})
        self.assertEqual(completed_by_bash("run case.toml --units ="), {"si", "us", "engineering-metric"})

    def test_leaves_files_to_bash(self):
        self.assertEqual(completed_by_bash("run ex"), set())
        self.assertEqual(completed_by_bash("materials --picture "), set())


@unittest.skipUnless(shutil.which("zsh"), "no zsh")
class Zsh(unittest.TestCase):
    def test_is_valid(self):
        subprocess.run(["zsh", "-n", FOLDER / "_dashpad"], check=True)

    def test_has_every_option(self):
        for words in COMMANDS:
            name = re.escape("_".join(("_dashpad", *words)))
            function = re.search(rf"^{name}\(\) {{\n(.*?)^}}", read("_dashpad"), re.M | re.S).group(1)
            for names, allowed in options(words):
                for option in names:
                    self.assertRegex(function, rf"(\*|\)){option}[=+]?\[", words)
                self.assertIn(f":({' '.join(allowed)})'" if allowed else "", function)


@unittest.skipUnless(shutil.which("fish"), "no fish")
class Fish(unittest.TestCase):
    def completed(self, line):
        path = f"{pathlib.Path(COMMAND).parent}:{os.environ['PATH']}"
        script = f"source {FOLDER}/dashpad.fish; complete -C 'dashpad {line}'"
        found = output("fish", "--no-config", "-c", script, env={**os.environ, "PATH": path}, cwd=FOLDER)
        return {line.split("\t")[0] for line in found.splitlines()}

    def test_completes_every_option(self):
        subprocess.run(["fish", "-n", FOLDER / "dashpad.fish"], check=True)
        for words in COMMANDS:
            longs = {name for names, _ in options(words) for name in names if name.startswith("--")}
            self.assertEqual(self.completed(" ".join((*words, "--"))), longs)

    def test_completes_values_and_names(self):
        self.assertEqual(self.completed("run --units "), {"si", "us", "engineering-metric"})
        self.assertEqual(self.completed("study su"), {"summary"})
        self.assertLessEqual(names_in("materials"), self.completed("material-test "))
        self.assertLessEqual(names_in("standards"), self.completed("assess --standard "))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
