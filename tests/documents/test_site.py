"""What makes the site of the documents, and what checks it, without MkDocs."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

import documents  # noqa: E402


class Links(unittest.TestCase):
    def rewritten(self, text, source="docs/theory.md", page="theory.md"):
        links = documents.Links(ROOT)
        return links.rewrite(text, source, page), links.files

    def test_lead_to_pages(self):
        self.assertEqual(self.rewritten("[a](fits.md#limits)")[0], "[a](fits.md#limits)")
        self.assertEqual(self.rewritten("[a](docs/fits.md)", "README.md", "overview.md")[0], "[a](fits.md)")
        self.assertEqual(self.rewritten("[a](../../README.md)", "docs/decisions/0001-libraries.md",
                                        "decisions/0001-libraries.md")[0], "[a](../overview.md)")
        self.assertEqual(self.rewritten("![a](images/figure-2-9.svg)")[0], "![a](images/figure-2-9.svg)")

    def test_lead_to_copies_of_files(self):
        text, files = self.rewritten("[case](../examples/disc-on-mat.toml), [all](../src/impact)")
        self.assertEqual(text, "[case](files/examples/disc-on-mat.toml.html), [all](files/src/impact/index.html)")
        self.assertEqual(files, {"examples/disc-on-mat.toml", "src/impact"})

    def test_name_documents_by_their_titles(self):
        self.assertEqual(self.rewritten("([glossary.md](glossary.md))")[0], "([Glossary](glossary.md))")

    def test_in_code_are_none(self):
        for text in ("`[a](b.md)`", "```\n[a](b.md)\n```", "<!-- [a](b.md) -->"):
            self.assertEqual(self.rewritten(text)[0], text)

    def test_to_nothing_are_refused(self):
        with self.assertRaises(SystemExit):
            self.rewritten("[a](nothing.toml)")


class Markdown(unittest.TestCase):
    def test_lists_are_set_apart_and_indented(self):
        self.assertEqual(documents.as_mkdocs_reads_it("Text:\n- a\n  on\n  - b\n\n1. c\n   d\n"),
                         "Text:\n\n- a\n    on\n    - b\n\n1. c\n    d\n")

    def test_tables_are_set_apart_but_no_formulas(self):
        self.assertEqual(documents.as_mkdocs_reads_it("Text\n| a |\n|---|\n"), "Text\n\n| a |\n|---|\n")
        self.assertEqual(documents.as_mkdocs_reads_it("Text $a -\n|b|$ text\n"), "Text $a -\n|b|$ text\n")

    def test_code_stays_as_it_is(self):
        text = "Text:\n\n```text\nText\n- a\n  - b\n| c |\n```\n"
        self.assertEqual(documents.as_mkdocs_reads_it(text), text)

    def test_names_of_files_to_write_are_titles(self):
        self.assertEqual(documents.as_mkdocs_reads_it("```toml a.toml\nb = 1\n```\n"),
                         '```toml title="a.toml"\nb = 1\n```\n')


class Check(unittest.TestCase):
    def faults(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                pathlib.Path(folder, f"{name}.html").write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, ROOT / "tests/documents/check_site.py", folder],
                                  capture_output=True, text=True, check=False)
            return done.returncode, done.stdout

    def test_passes_links_that_lead_somewhere(self):
        self.assertEqual(self.faults(a='<a href="b.html#c">', b='<p id="c"><a href="https://example.org">')[0], 0)

    def test_finds_what_leads_nowhere(self):
        for link, fault in (("c.html", "no such file"), ("b.html#d", "no such anchor"), ("#d", "no such anchor"),
                            ("../a.html", "leads out of the site"), ("/a.html", "leads out of the site")):
            code, printed = self.faults(a=f'<a href="{link}">', b="")
            self.assertEqual((code, printed.strip()), (1, f"a.html:1: {link}: {fault}"))

    def test_finds_what_is_loaded_from_the_web(self):
        self.assertIn("loaded from the web", self.faults(a='<script src="https://example.org/a.js"></script>')[1])


if __name__ == "__main__":
    unittest.main()
