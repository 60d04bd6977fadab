#!/usr/bin/env python3
"""Makes the site of the documents. See docs/decisions/0025-site.md.

    build.py --command DASHPAD --out FOLDER      exit code 1 if anything is broken: a command, a formula, a link
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

import documents
import files
import runs

ROOT = pathlib.Path(__file__).resolve().parents[2]
OWN = pathlib.Path(__file__).resolve().parent
KATEX = pathlib.Path("/usr/share/nodejs/katex/dist")


def said(text, since):
    print(f"{text} ({time.monotonic() - since:.1f} s)", file=sys.stderr)


def checked(arguments, **options):
    """Runs a program quietly; shows what it printed if it fails."""
    done = subprocess.run(
        arguments, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options
    )
    if done.returncode:
        names = " ".join(str(word) for word in arguments[:2])
        raise SystemExit(f"{done.stdout}\nfailed: {names}")
    return done.stdout


def documents_of_the_site():
    """Documents by their paths in the project."""
    named = [path for path in documents.NAMES if path.endswith(".md")]
    found = [str(path.relative_to(ROOT)) for path in sorted((ROOT / "docs").glob("*.md"))]
    found += [str(path.relative_to(ROOT)) for path in sorted((ROOT / "docs/decisions").glob("*.md"))]
    return list(dict.fromkeys(path for path in named + found if (ROOT / path).exists()))


def api(made, pages):
    """The C++ API by Doxygen, and the headers with their first sentences."""
    checked(["doxygen", OWN / "Doxyfile"], cwd=ROOT,
            env={"PATH": "/usr/local/bin:/usr/bin:/bin", "DASHPAD_API": str(made / "api"), "LC_ALL": "C.UTF-8"})
    shutil.copytree(made / "api/html", pages / "api")
    for page in (pages / "api").glob("class*.html"):  # a link to nested classes that are private, which leads nowhere
        text = page.read_text(encoding="utf-8")
        if 'name="nested-classes"' not in text:
            page.write_text(text.replace('<a href="#nested-classes">Classes</a> &#124;', ""), encoding="utf-8")
    tags = (made / "api/tags.xml").read_text(encoding="utf-8")
    place = {}
    for compound in re.findall(r'<compound kind="file">.*?<filename>[^<]*</filename>', tags, re.S):
        name, path, page = (re.search(f"<{tag}>([^<]*)</{tag}>", compound) for tag in ("name", "path", "filename"))
        place[path.group(1) + name.group(1)] = page.group(1)
    text, folder = "", None
    for header in sorted((ROOT / "include/dashpad").rglob("*.hpp"), key=lambda path: (str(path.parent), path.name)):
        comment = re.search(r"^((?:///.*\n)+)", header.read_text(encoding="utf-8"), re.M)
        words = " ".join(line.removeprefix("///").strip() for line in comment.group(1).splitlines()) if comment else ""
        sentence = re.match(r".*?[.](?= |$)|.*", words).group(0)
        if str(header.parent) != folder:
            folder = str(header.parent)
            name = header.parent.relative_to(ROOT / "include").as_posix().removeprefix("dashpad/")
            text += f"\n### {name}\n\n| header | contents |\n|---|---|\n"
        page = place[str(header)]
        shown = sentence.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_")
        text += f"| [{header.name}](api/{page}) | {shown} |\n"
    return text


def navigation(settings, titles):
    """The navigation of MkDocs: titles and pages, without those that do not exist."""
    used, parts = set(), []

    def entry(path, title=None):
        page = documents.page_of(path) or path
        if page not in titles:
            return None
        used.add(page)
        return {title or titles[page]: page}

    for part in settings["part"]:
        if "page" in part:
            parts.append(entry(part["page"], part.get("title")))
            continue
        names = []
        for name in part["pages"]:
            if isinstance(name, list):
                names.append((name[1], name[0]))
            else:
                found = sorted(ROOT.glob(name)) if "*" in name else [ROOT / name]
                names += [(str(path.relative_to(ROOT)),) for path in found]
        if inside := [item for name in names if (item := entry(*name))]:
            parts.append({part["title"]: inside})
    if others := sorted(set(titles) - used):
        parts.append({"More": [{titles[page]: page} for page in others]})
    return [part for part in parts if part]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--command", required=True, type=pathlib.Path, help="the program dashpad")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="folder of the site; it is replaced")
    given = parser.parse_args()
    site = given.out.resolve()
    made = site.parent / (site.name + "-parts")
    shutil.rmtree(made, ignore_errors=True)
    pages = made / "pages"
    pages.mkdir(parents=True)

    begin = time.monotonic()
    links = documents.Links(ROOT)
    runner = runs.Runner(given.command, ROOT, made / "runs")
    pictures, texts = set(), {}
    for path in documents_of_the_site():
        text = (ROOT / path).read_text(encoding="utf-8")
        page = documents.page_of(path)
        text = documents.as_mkdocs_reads_it(links.rewrite(text, path, page))
        texts[page] = runs.with_answers(text, runner, pictures)
    said(f"{len(texts)} documents", begin)

    begin = time.monotonic()
    with open(OWN / "examples.toml", "rb") as file:
        texts["gallery.md"], count = runs.gallery(tomllib.load(file), ROOT, runner, links, pictures)
    said(f"{count} examples", begin)
    texts["commands.md"], count = runs.commands(runner)
    decisions = sorted(page for page in texts if page.startswith("decisions/"))
    texts["decisions.md"] = "# Decisions\n\nWhy things are as they are, in the order in which it was decided.\n\n"
    texts["decisions.md"] += "".join(f"- [{documents.title_of(texts[page])}]({page})\n" for page in decisions)

    begin = time.monotonic()
    texts["cpp-api.md"] += api(made, pages)
    said("C++ API", begin)

    begin = time.monotonic()
    shutil.copytree(ROOT / "docs/images", pages / "images")
    (pages / "made").mkdir()
    for name in sorted(pictures):
        shutil.copy(made / "runs" / name, pages / "made" / name)
    (pages / "assets").mkdir()
    for name in ("site.css", "site.js"):
        shutil.copy(OWN / name, pages / "assets" / name)
    logo = (OWN / "logo.svg").read_text(encoding="utf-8")
    (pages / "assets/logo.svg").write_text(logo, encoding="utf-8")
    (pages / "assets/favicon.svg").write_text(logo.replace("#fff", "#546d78"), encoding="utf-8")  # on white tabs
    (pages / "assets/katex").mkdir()
    style = (KATEX / "katex.min.css").read_text(encoding="utf-8")
    style = re.sub(r",url\([^)]*\.(?:woff|ttf)\) format\([^)]*\)", "", style)  # every browser reads woff2
    (pages / "assets/katex/katex.min.css").write_text(style, encoding="utf-8")
    shutil.copytree(KATEX / "fonts", pages / "assets/katex/fonts", ignore=shutil.ignore_patterns("*.ttf", "*.woff"))
    count = files.write(ROOT, links.files, pages, documents.page_of)
    for page, text in texts.items():
        (pages / page).parent.mkdir(parents=True, exist_ok=True)
        (pages / page).write_text(text, encoding="utf-8")
    said(f"{count} files that documents link to", begin)

    begin = time.monotonic()
    with open(OWN / "navigation.toml", "rb") as file:
        titles = {page: documents.title_of(text) or page for page, text in texts.items()}
        nav = navigation(tomllib.load(file), titles)
    settings = (OWN / "mkdocs.yml").read_text(encoding="utf-8")
    settings += f"docs_dir: {json.dumps(str(pages))}\nsite_dir: {json.dumps(str(site))}\nnav: {json.dumps(nav)}\n"
    (made / "mkdocs.yml").write_text(settings, encoding="utf-8")
    checked(["mkdocs", "build", "--quiet", "--strict", "--clean", "--config-file", made / "mkdocs.yml"])
    for name in ("404.html", "sitemap.xml", "sitemap.xml.gz"):  # they are for one address on the web
        (site / name).unlink(missing_ok=True)
    said("pages by MkDocs", begin)

    begin = time.monotonic()
    written = [site / page.replace(".md", ".html") for page in texts]
    said(checked(["node", OWN / "formulas.mjs", *written]).strip(), begin)

    begin = time.monotonic()
    said(checked([sys.executable, ROOT / "tests/documents/check_site.py", site]).strip(), begin)


if __name__ == "__main__":
    main()
