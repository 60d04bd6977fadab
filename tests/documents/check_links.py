"""Every link of the documents leads somewhere: files and folders that the project has, and headings in them.

    check_links.py ROOT      exit code 1, and a line each, for those that do not

Links to the web are left alone. Anchors are those that GitHub makes of headings.
"""

import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"!?\[[^\]\[]*(?:\[[^\]]*\][^\]\[]*)*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")


def without_code(text):
    """Blanks in place of fenced and inline code, in which brackets are no links."""
    text = re.sub(r"^(```|~~~).*?^\1", lambda found: "\n" * found.group(0).count("\n"), text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchor_of(heading):
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def anchors_of(document):
    text = re.sub(r"^(```|~~~).*?^\1", "", document.read_text(encoding="utf-8"), flags=re.M | re.S)
    found = {}
    for line in text.splitlines():
        if heading := HEADING.match(line):
            anchor = anchor_of(heading.group(1))
            found[anchor] = found.get(anchor, 0) + 1
    return {name if i == 0 else f"{name}-{i}" for name, count in found.items() for i in range(count)}


def faults_of(document, root):
    text = without_code(document.read_text(encoding="utf-8"))
    for found in LINK.finditer(text):
        link = found.group(1)
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (document.parent / path).resolve() if path else document
        line = text[: found.start()].count("\n") + 1
        place = f"{document.relative_to(root)}:{line}"
        if not target.exists():
            yield f"{place}: {link}: no such file"
        elif root not in target.parents and target != root:
            yield f"{place}: {link}: leads out of the project"
        elif anchor and target.suffix == ".md" and anchor not in anchors_of(target):
            yield f"{place}: {link}: no such heading"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    # A clone has git; an archive of the sources may have neither it nor anything beside the sources.
    listed = subprocess.run(["git", "-C", root, "ls-files", "*.md"], capture_output=True, text=True, check=False)
    found = listed.stdout.split() if listed.returncode == 0 else root.rglob("*.md")
    names = [pathlib.Path(root, name).relative_to(root) for name in found]
    made = {"build", "node_modules"}
    documents = [root / name for name in names if (root / name).exists() and not made & set(name.parts)]
    faults = [fault for document in documents for fault in faults_of(document, root)]
    print("\n".join(faults) or f"{len(documents)} documents, no link leads nowhere")
    return 1 if faults or not documents else 0


if __name__ == "__main__":
    sys.exit(main())
