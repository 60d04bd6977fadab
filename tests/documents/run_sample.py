"""A sample of the library prints what its first comment shows, and writes the files that this names.

    run_sample.py PROGRAM SOURCE ROOT      exit code 1, and the difference, where it does not

The program runs in an empty folder, with ROOT, the folder of examples, materials and standards, as its argument. The last
lines of the first comment that are indented are its output; "..." stands for any number of lines.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

from run_examples import missing_from, trimmed

INDENT = "//   "


def first_comment(text):
    """Its lines."""
    lines = text.splitlines()
    end = next((i for i, line in enumerate(lines) if not line.startswith("//")), len(lines))
    return trimmed(["" if line == "//" else line for line in lines[:end]])


def shown_in(comment):
    """The output at its end."""
    start = len(comment)
    while start > 0 and (not comment[start - 1] or comment[start - 1].startswith(INDENT)):
        start -= 1
    while start < len(comment) and not comment[start]:
        start += 1
    return [line[len(INDENT):] for line in comment[start:]]


def written_by(comment):
    """The files that it says are written."""
    words = " ".join(line.removeprefix("//").strip() for line in comment)
    found = re.search(r"\bWrites (.*?)(?:[:;]|\.(?: |$))", words)
    return re.findall(r"[\w-]+\.(?:csv|html|svg)\b", found.group(1)) if found else []


def faults_of(program, source, root):
    comment = first_comment(source.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, root], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, encoding="utf-8", check=False)
        missing = missing_from([line.rstrip() for line in done.stdout.splitlines()], shown_in(comment))
        if done.returncode != 0:
            yield f"exit code {done.returncode}\n{done.stdout}"
        elif missing is not None:
            yield f"shown, not printed there: {missing}\n  printed:\n{done.stdout}"
        for name in written_by(comment):
            file = pathlib.Path(folder, name)
            if not file.is_file() or file.stat().st_size == 0:
                yield f"not written: {name}"


def main():
    program, source, root = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    faults = list(faults_of(program, source, root))
    print("\n".join(faults) or f"{source.name} shows what it prints")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
