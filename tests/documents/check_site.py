"""Every link of a folder of pages leads somewhere, within it or to the web, and no page loads anything from the web.

    check_site.py FOLDER      exit code 1, and a line each, for links that do not
"""

import html.parser
import multiprocessing
import os
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The anchors and links of a page."""

    def __init__(self):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        if values.get("id"):
            self.anchors.add(values["id"])
        if tag == "a" and values.get("name"):
            self.anchors.add(values["name"])
        place = self.getpos()[0]
        for key in ("href", "src", "data"):
            if values.get(key) is None or (key == "data" and tag != "object"):
                continue
            self.links.append((place, values[key]))
            if tag not in ("a", "area") and re.match(r"(https?:)?//", values[key]) and values.get("rel") != "canonical":
                self.loaded.append((place, values[key]))


def read(file):
    page = Page()
    page.feed(file.read_text(encoding="utf-8"))
    return file, page.anchors, page.links, page.loaded


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    found = sorted(folder.rglob("*.html"))
    with multiprocessing.Pool() as pool:
        pages = pool.map(read, found, chunksize=8)
    sheets = []
    for file in sorted(folder.rglob("*.css")):
        named = re.findall(r"url\([\"']?([^)\"'#]+)", file.read_text(encoding="utf-8"))
        loaded = [(1, link) for link in named if re.match(r"(https?:)?//", link)]
        sheets.append((file, set(), [(1, link) for link in named], loaded))
    anchors = {str(file): names for file, names, _, _ in pages}
    present, faults, count = {}, [], 0
    for file, _, links, loaded in pages + sheets:
        name = file.relative_to(folder)
        faults += [f"{name}:{line}: {link}: loaded from the web" for line, link in loaded]
        for line, link in links:
            if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|//", link):
                continue
            count += 1
            path, _, anchor = link.partition("#")
            path = urllib.parse.unquote(path.partition("?")[0])
            target = os.path.normpath(os.path.join(file.parent, path)) if path else str(file)
            if path.startswith("/") or not (target + "/").startswith(f"{folder}/"):
                faults.append(f"{name}:{line}: {link}: leads out of the site")
            elif not present.setdefault(target, os.path.isfile(target)):
                faults.append(f"{name}:{line}: {link}: no such file")
            elif anchor and target in anchors and urllib.parse.unquote(anchor) not in anchors[target]:
                faults.append(f"{name}:{line}: {link}: no such anchor")
    print("\n".join(faults) or f"{len(pages)} pages, {count} links, none leads nowhere")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
