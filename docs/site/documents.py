"""The documents of the project as pages of the site: links lead to pages, lists are written as MkDocs reads them."""

import pathlib
import posixpath
import re

FENCE = re.compile(r"^ *(```|~~~)")
ITEM = re.compile(r"^( *)([-*+]|\d+[.)])( +)(?=\S)")
# Fenced code, inline code, and comments: what is in them is no link.
CODE = re.compile(r"^ *(```|~~~)[^\n]*\n.*?^ *\1[^\n]*$|(`+)(?!`).+?(?<!`)\2(?!`)|<!--.*?-->", re.M | re.S)
# A link in text, with its label where that has no brackets of its own, or in HTML.
TARGET = re.compile(
    r"((?:(?<!!)\[([^\]\[]+)|)\]\()([^)\s]+)((?:\s+\"[^\"]*\")?\))|((?:href|src)=\")([^\"]+)(\")"
)

SHOWN_BY_BROWSERS = (".svg", ".png", ".jpg", ".gif", ".pdf", ".html")

# Pages of documents and folders; docs/NAME.md is NAME.md.
NAMES = {
    "README.md": "overview.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "bench/README.md": "benchmarks.md",
    "data/validation/README.md": "validation-data.md",
    "docs/README.md": "documents.md",
    "docs/site/index.md": "index.md",
    "docs/site/api.md": "cpp-api.md",
    "docs/decisions": "decisions.md",
    "examples": "gallery.md",
    "include/dashpad": "api/index.html",
}


def page_of(path):
    """Path in the site of a document of the project, or None for what is no document of the site."""
    if path in NAMES:
        return NAMES[path]
    if path.startswith("docs/images/") or (path.startswith("docs/") and path.endswith(".md")):
        return path.removeprefix("docs/")
    return None


class Links:
    """Links of documents as links of the site. `files` collects what is linked and is no document."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = set()

    def target(self, path):
        """Path in the site of a file or folder of the project."""
        if page := page_of(path):
            return page
        if not (self.root / path).exists():
            raise SystemExit(f"{path}: no such file, but a document links to it")
        self.files.add(path)
        if path.endswith(SHOWN_BY_BROWSERS):
            return f"files/{path}"
        return f"files/{path}/index.html" if (self.root / path).is_dir() else f"files/{path}.html"

    def title(self, path):
        """Title of a document, which a reader of the site knows it by."""
        return title_of((self.root / path).read_text(encoding="utf-8")) if page_of(path) else path

    def rewritten(self, link, source, page):
        if re.match(r"[a-z]+:|#|//", link):
            return link
        path, mark, anchor = link.partition("#")
        target = self.target(posixpath.normpath(posixpath.join(posixpath.dirname(source), path)))
        return posixpath.relpath(target, posixpath.dirname(page) or ".") + mark + anchor

    def rewrite(self, text, source, page):
        """The text of the document `source` with the links of the page `page`."""

        def replaced(found):
            if found.group(5):
                return found.group(5) + self.rewritten(found.group(6), source, page) + found.group(7)
            before, label, link, after = found.groups()[:4]
            path = link.partition("#")[0]
            if label and label in (path, posixpath.basename(path)) and path.endswith(".md"):
                before = f"[{self.title(posixpath.normpath(posixpath.join(posixpath.dirname(source), path)))}]("
            return before + self.rewritten(link, source, page) + after

        return outside_code(text, lambda part: TARGET.sub(replaced, part))


def outside_code(text, change):
    parts, end = [], 0
    for code in CODE.finditer(text):
        parts += [change(text[end : code.start()]), code.group(0)]
        end = code.end()
    return "".join(parts) + change(text[end:])


def as_mkdocs_reads_it(text):
    """Lists and tables may follow a line of text at once, and lists in lists are indented by four."""
    lines, levels, in_fence, before = [], [], False, ""
    for line in text.splitlines():
        indent = len(line) - len(line.lstrip())
        if not in_fence and line.strip():
            item = ITEM.match(line)
            while levels and indent < levels[-1] and (item or not before.strip()):
                levels.pop()
            if item:
                if not levels and before.strip() and not ITEM.match(before) and not before.startswith(" "):
                    lines.append("")
                lines.append("    " * len(levels) + line.lstrip())
                levels.append(indent + len(item.group(2)) + len(item.group(3)))
                before = line
                continue
            if re.match(r"\|.*\|$", line) and before.strip() and not before.startswith("|"):
                lines.append("")
        if FENCE.match(line):
            in_fence = not in_fence
            line = re.sub(r"^( *```\w+) ([^\s=\"]+)$", r'\1 title="\2"', line)  # the name of a file to write
        removed = min(indent, levels[-1] if levels else 0)
        lines.append(("    " * len(levels) + line[removed:]) if line.strip() else "")
        before = line
    return "\n".join(lines).replace("<details>", '<details markdown="1">') + "\n"


def title_of(text):
    """The first heading, without marks."""
    heading = re.search(r"^# +(.*?) *#*$", text, re.M)
    return re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1)) if heading else None
