"""What commands print and draw: for the front page, the examples and the reference of the commands."""

import html
import os
import pathlib
import re
import shlex
import subprocess
import tomllib
from concurrent.futures import ThreadPoolExecutor

RUN = re.compile(r"^<!-- run: (\d+) lines?(?:; (.*?))? -->\n```sh\n(.*?)^```$", re.M | re.S)
# The commit of a build: it says nothing to a reader of an answer.
COMMIT = re.compile(r" \([0-9a-f]{12}(-dirty)?\)")


class Runner:
    """Runs commands as they are written, in a folder that has the examples; what they write stays there."""

    def __init__(self, command, root, folder):
        self.command = pathlib.Path(command).resolve()
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.environment = os.environ | {
            "DASHPAD_MATERIALS": f"{root}/materials",
            "DASHPAD_STANDARDS": f"{root}/standards",
            "DASHPAD_VALIDATION_DATA": f"{root}/data/validation",
            "DASHPAD_ENGINE": f"{root}/build/wasm/engine.wasm.lzma",
        }
        examples = self.folder / "examples"
        if not examples.exists():
            examples.symlink_to(pathlib.Path(root, "examples").resolve())

    def printed(self, line):
        """What a command prints. Exit codes 3 and 4 are answers too."""
        words = shlex.split(line.replace("\\\n", " "))
        if words[0] != "dashpad":
            raise SystemExit(f"not a command of Dashpad: {line}")
        done = subprocess.run(
            [self.command, *words[1:]], cwd=self.folder, env=self.environment, text=True, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
        )
        if done.returncode not in (0, 3, 4):
            raise SystemExit(f"{line}\n{done.stdout}ended with exit code {done.returncode}")
        return COMMIT.sub("", done.stdout).rstrip("\n")

    def written(self, line, suffix):
        """The file with that suffix which the command writes, if it was told to."""
        names = [word for word in shlex.split(line.replace("\\\n", " ")) if word.endswith(suffix)]
        names = [name for name in names if not name.startswith("examples/")]
        return names[0].removeprefix("./") if names else None


def first_lines(text, count):
    lines = text.split("\n")
    return text if len(lines) <= count else "\n".join(lines[:count]).rstrip("\n") + "\n..."


def console(line, text):
    """A command and what it prints; a long one is broken before an option."""
    rows = [""]
    for part in re.split(r" (?=--)", line):
        if len(rows[-1]) + len(part) > 86 and rows[-1]:
            rows.append("")
        rows[-1] += (" " if rows[-1] else "") + part
    shown = line if "\\\n" in line else " \\\n    ".join(rows)
    return f"```console\n$ {shown}\n{text}\n```\n"


def with_answers(text, runner, pictures):
    """A document in which each command below <!-- run: N lines; ALT --> is followed by what it prints and draws."""

    def replaced(found):
        count, alt, line = int(found.group(1)), found.group(2), found.group(3).strip()
        written = console(line, first_lines(runner.printed(line), count))
        if picture := runner.written(line, ".svg"):
            pictures.add(picture)
            written += f"\n![{alt or ''}](made/{picture}){{.picture}}\n"
        if page := runner.written(line, ".html"):
            pictures.add(page)
            name = "Open the live page" if " explore " in line else "The page of this answer"
            written += f"\n[{name}](made/{page})\n"
        return written

    return RUN.sub(replaced, text)


# --- The examples ---


def comment_of(path):
    """The comment at the beginning of a file."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line[1:].removeprefix(" "))
    return "\n".join(lines)


def question_of(path):
    found = re.search(r"^Question: *(.*(?:\n {6,}.*)*)", comment_of(path), re.M)
    if not found:
        return None
    words = " ".join(found.group(1).split())
    return words[0].upper() + words[1:]


def lead(text):
    """The answer and the figures that matter: the first paragraph and the rows below it."""
    return first_lines(text, min(18, len("\n\n".join(text.split("\n\n")[:2]).split("\n"))))


def is_tall(picture):
    size = re.search(r'width="([0-9.]+)" height="([0-9.]+)"', picture.read_text(encoding="utf-8"))
    return size is not None and float(size.group(2)) > 0.9 * float(size.group(1))


def example(path, own, root, runner):
    file = pathlib.Path(root, path)
    name = own.get("name", file.stem)
    lines = own.get("commands", [f"dashpad run {path} --drawing {name}.svg --report {name}.html"])
    answers = [runner.printed(line) for line in lines]
    title = own.get("title")
    if not title and path.endswith(".toml"):
        title = tomllib.loads(file.read_text(encoding="utf-8")).get("title")
    question = own.get("question") or question_of(file)
    if not title or not question:
        raise SystemExit(f"{path}: no {'question' if title else 'title'} for the page of examples")
    picture = next((made for line in lines if (made := runner.written(line, ".svg"))), None)
    page = next((made for line in lines if (made := runner.written(line, ".html"))), None)
    return {"name": name, "path": path, "title": title, "question": question, "lines": lines, "answers": answers,
            "picture": picture, "page": page}


def gallery(settings, root, runner, links, pictures):
    """The page of all examples. An example that no group names comes last."""
    own = settings.get("example", {})
    groups = [dict(group) for group in settings["group"]]
    named = {path for group in groups for path in group["examples"]}
    others = sorted(str(path.relative_to(root)) for path in pathlib.Path(root, "examples").glob("*.toml"))
    if others := [path for path in others if path not in named]:
        groups.append({"title": "Others", "examples": others})
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        paths = [path for group in groups for path in group["examples"]]
        done = dict(zip(paths, pool.map(lambda path: example(path, own.get(path, {}), root, runner), paths)))

    text = "---\nhide: [toc]\n---\n\n# Examples\n\n"
    text += ("Each example is a file that comes with Dashpad. The answers below are the first lines of what the "
             "commands print, and the pictures are those that they draw.\n\n")
    for group in groups:
        text += f"**{group['title']}**\n\n" + '<div class="gallery">\n'
        for path in group["examples"]:
            made = done[path]
            image = ""
            if made["picture"]:
                shape = ' class="tall"' if is_tall(runner.folder / made["picture"]) else ""
                image = f'<img{shape} src="made/{made["picture"]}" alt="" loading="lazy">'
            text += f'<a href="#{made["name"]}">{image}<span>{html.escape(made["question"])}</span></a>\n'
        text += "</div>\n\n"
    for group in groups:
        text += f"## {group['title']}\n\n"
        for path in group["examples"]:
            made = done[path]
            text += f"### {made['title']} {{#{made['name']}}}\n\n{made['question']}\n{{.question}}\n\n"
            if made["picture"]:
                pictures.add(made["picture"])
                text += f"![{made['title']}](made/{made['picture']}){{.picture}}\n\n"
            for line, answer in zip(made["lines"], made["answers"]):
                text += console(line, lead(answer)) + "\n"
            text += f"[{path}]({links.target(path)})"
            if made["page"]:
                pictures.add(made["page"])
                text += f" · [the page of the result](made/{made['page']})"
            text += "\n\n"
    return text, len(done)


# --- The reference of the commands ---


def groups_of(text):
    """Names of the subcommands that a help lists, below their headings."""
    groups, heading, inside = {}, None, False
    others = ("Options", "Positionals", "Examples", "Exit codes", "Start here")
    for line in text.split("\n"):
        if match := re.match(r"^([A-Z][^:]*):$", line):
            heading, inside = match.group(1), match.group(1) not in others
        elif inside and (match := re.match(r"^  ([a-z][a-z0-9-]*) {2,}\S", line)):
            groups.setdefault(heading, []).append(match.group(1))
        elif line and not line.startswith(" "):
            inside = False
    return groups


def commands(runner):
    """The page of all commands, from what --help prints."""
    whole = runner.printed("dashpad --help")
    text = ("# Commands\n\nWhat each command prints with `--help`. The subjects have documents of their own, which the "
            f"parts *Answers* and *Reference* list.\n\n## dashpad\n\n```text\n{whole}\n```\n\n")
    count = 1
    for heading, names in groups_of(whole).items():
        text += f"## {heading}\n\n"
        for name in names:
            own = runner.printed(f"dashpad {name} --help")
            text += f"### dashpad {name}\n\n```text\n{own}\n```\n\n"
            count += 1
            for below in groups_of(own).get("Subcommands", []):
                printed = runner.printed(f"dashpad {name} {below} --help")
                text += f"### dashpad {name} {below}\n\n```text\n{printed}\n```\n\n"
                count += 1
    return text, count
