"""The commands that documents show are run, and print what the documents show.

    run_examples.py COMMAND ROOT DOCUMENT...      exit code 1, and the difference, where they do not

Each document has a scratch folder with a copy of examples/, in which its blocks are taken in order:

- ```toml NAME (or any language): the block is a file that the reader writes; it is written under that name.
- ```console: lines with "$ dashpad ..." are run, by a shell, and the lines below must be printed, one below the other, on
  standard output or standard error. A line "..." stands for any number of lines; without it at the beginning or the end,
  the output begins and ends there. A command ends with exit code 0, with 3 or 4 for a verdict that is no pass, or with 2 if
  the last line shown counts errors.
- "$ ./do run" is `dashpad run` of the case that it solves. Other commands are not run.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^(```|~~~)\s*(\S*)\s*(\S*)\s*$")
ERRORS = re.compile(r"^\d+ errors?\b")
FIRST_CASE = "examples/helmet-pad-10fps.toml"
FIRST_LINE = "Building the command ..."


def blocks_of(text):
    """Language, name, line of the first line inside, and lines of each fenced block."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        found = FENCE.match(line)
        if fence is None and found:
            fence, language, name, first, lines = found.group(1), found.group(2), found.group(3), number + 1, []
        elif fence is not None and line.strip() == fence:
            yield language, name, first, lines
            fence = None
        elif fence is not None:
            lines.append(line)


def commands_of(first, lines):
    """Line, command and shown output of each command of a console block."""
    found = []
    continued = False
    for number, line in enumerate(lines, first):
        if line.startswith("$ "):
            found.append((number, line[2:], []))
        elif continued:
            found[-1] = (found[-1][0], found[-1][1] + "\n" + line, [])
        elif found:
            found[-1][2].append(line)
        continued = (line.startswith("$ ") or continued) and line.endswith("\\")
    return found


def missing_from(printed, shown):
    """The first shown line that is not printed in its place; None if all are and nothing is left out unmarked."""
    text = "".join(line + "\n" for line in printed)
    parts = [r"(?:.*\n)*?" if line.strip() == "..." else re.escape(line.rstrip()) + r"\n" for line in shown]
    if re.fullmatch("".join(parts), text):
        return None
    missing = (line for count, line in enumerate(shown, 1) if not re.match("".join(parts[:count]), text))
    return next(missing, "(nothing, but more is printed)")


def trimmed(lines):
    """Without blank lines at the end."""
    while lines and not lines[-1].strip():
        lines = lines[:-1]
    return lines


def faults_of(document, command, root):
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder, "scratch")
        scratch.mkdir()
        shutil.copytree(root / "examples", scratch / "examples")
        programs = pathlib.Path(folder, "programs")
        programs.mkdir()
        (programs / "dashpad").symlink_to(command)
        environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8",
                       "DASHPAD_MATERIALS": str(root / "materials"), "DASHPAD_STANDARDS": str(root / "standards")}
        count = 0
        for language, name, first, lines in blocks_of(document.read_text(encoding="utf-8")):
            if name:
                (scratch / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
            if language != "console":
                continue
            for number, typed, shown in commands_of(first, lines):
                run = typed
                words = typed.split()
                if words[:2] == ["./do", "run"]:
                    arguments = words[2:] if len(words) > 2 and not words[2].startswith("-") else [FIRST_CASE, *words[2:]]
                    run = shlex.join(["dashpad", "run", *arguments])
                    shown = shown[1:] if shown[:1] == [FIRST_LINE] else shown
                elif words[:1] != ["dashpad"]:
                    continue
                done = subprocess.run(["bash", "-c", run], cwd=scratch, env=environment, stdin=subprocess.DEVNULL,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8",
                                      check=False)
                count += 1
                place = f"{document.relative_to(root)}:{number}: {typed}"
                printed = trimmed([line.rstrip() for line in done.stdout.splitlines()])
                shown = trimmed(shown)
                right = (2,) if shown and ERRORS.match(shown[-1]) else (0, 3, 4)
                if done.returncode not in right:
                    yield f"{place}\n  exit code {done.returncode}\n{done.stdout}"
                elif (missing := missing_from(printed, shown)) is not None:
                    yield f"{place}\n  shown, not printed there: {missing}\n  printed:\n" + done.stdout
        if count == 0:
            yield f"{document.relative_to(root)}: no command that can be run"


def main():
    command, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    documents = [root / name for name in sys.argv[3:]]
    faults = [fault for document in documents for fault in faults_of(document, command, root)]
    print("\n".join(faults) or f"{len(documents)} documents show what the command prints")
    return 1 if faults or not documents else 0


if __name__ == "__main__":
    sys.exit(main())
