"""Pages that show files of the project which documents link to: cases, sources, tables."""

import html
import pathlib
import subprocess

import documents
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound

LARGEST = 400_000  # bytes, beyond which a file is offered, not shown

PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{path} - Dashpad</title>
<link rel="stylesheet" href="{up}assets/file.css">
</head>
<body>
<header><a href="{up}index.html">Dashpad</a> / {path}</header>
<main>
{body}
</main>
</body>
</html>
"""


def style():
    light = HtmlFormatter(style="default").get_style_defs("pre")
    dark = HtmlFormatter(style="monokai").get_style_defs("pre")
    return f"""body {{ margin: 0 auto; max-width: 64rem; padding: 1rem; font: 16px/1.5 system-ui, sans-serif; }}
header {{ margin-bottom: 1rem; overflow-wrap: anywhere; }}
a {{ color: #1763b0; }}
pre {{ font: 13px/1.5 ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace; overflow-x: auto; }}
{light}
@media (prefers-color-scheme: dark) {{
body {{ background: #15191e; color: #dde1e6; }}
a {{ color: #7fb7f0; }}
{dark}
}}
pre {{ background: none !important; }}
pre .linenos {{ color: #767f89; background: none; user-select: none; }}
pre .err {{ border: 0; color: inherit; background: none; }}
@media (prefers-color-scheme: dark) {{ pre .linenos {{ color: #8b949e; }} }}
"""


def shown(path, text):
    try:
        lexer = get_lexer_for_filename(path, text) if not path.endswith(".hpp") else get_lexer_for_filename("x.cpp")
    except ClassNotFound:
        lexer = TextLexer()
    return highlight(text, lexer, HtmlFormatter(linenos="inline", wrapcode=False))


def listed(root, folder):
    """Files below a folder, as git has them; an archive of the sources has no git and nothing made beside them."""
    found = subprocess.run(["git", "-C", root, "ls-files", "--", folder], capture_output=True, text=True, check=False)
    names = found.stdout.split() if found.returncode == 0 else []
    if not names:
        names = [str(path.relative_to(root)) for path in pathlib.Path(root, folder).rglob("*") if path.is_file()]
    return sorted(names)


def write(root, paths, site, pages):
    """Writes a page for each of the files and folders; `pages` maps a document to its page, or None."""
    root, site = pathlib.Path(root), pathlib.Path(site)
    (site / "assets").mkdir(parents=True, exist_ok=True)
    (site / "assets/file.css").write_text(style(), encoding="utf-8")
    names = {}
    for path in sorted(paths):
        names[path] = listed(root, path) if (root / path).is_dir() else None
    wanted = set(paths) | {name for inside in names.values() if inside for name in inside if pages(name) is None}
    for path in sorted(wanted):
        is_folder = (root / path).is_dir()
        page = site / "files" / (f"{path}/index.html" if is_folder else f"{path}.html")
        up = "../" * (len(page.relative_to(site).parts) - 1)
        if is_folder:
            rows = "".join(
                f'<li><a href="{up}{target(name, pages)}">{html.escape(name)}</a></li>\n' for name in names[path]
            )
            body = f"<ul>\n{rows}</ul>"
        else:
            data = (root / path).read_bytes()
            raw = site / "files" / path
            raw.parent.mkdir(parents=True, exist_ok=True)
            raw.write_bytes(data)
            if path.endswith(documents.SHOWN_BY_BROWSERS):
                continue
            body = f'<p><a href="{html.escape(raw.name)}" download>Download</a></p>\n'
            try:
                body += shown(path, data.decode("utf-8")) if len(data) <= LARGEST else "<p>Too large to be shown.</p>"
            except UnicodeDecodeError:
                body += "<p>Not a text.</p>"
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(PAGE.format(path=html.escape(path), up=up, body=body), encoding="utf-8")
    return len(wanted)


def target(name, pages):
    page = pages(name)
    if page:
        return page.removesuffix(".md") + ".html" if page.endswith(".md") else page
    return f"files/{name}" if name.endswith(documents.SHOWN_BY_BROWSERS) else f"files/{name}.html"
