"""Runs the notebooks of examples/notebooks: run_notebooks.py EXAMPLES OUT [PICTURES].

Each becomes OUT/NAME.html, and the last picture of each PICTURES/NAME.png. An error in a cell ends it.
"""

import base64
import pathlib
import sys

import nbformat
from nbconvert import HTMLExporter
from nbconvert.preprocessors import ExecutePreprocessor


def last_picture(notebook):
    pictures = [output["data"]["image/png"] for cell in notebook.cells for output in cell.get("outputs", ())
                if "image/png" in output.get("data", {})]
    return base64.b64decode(pictures[-1])


def main(examples, out, pictures=None):
    for file in sorted(pathlib.Path(examples, "notebooks").glob("*.ipynb")):
        print(file.stem, flush=True)
        notebook = nbformat.read(file, as_version=4)
        ExecutePreprocessor(timeout=600, kernel_name="python3").preprocess(notebook, {"metadata": {"path": str(file.parent)}})
        page, _ = HTMLExporter(embed_images=True).from_notebook_node(notebook)
        pathlib.Path(out, f"{file.stem}.html").write_text(page, encoding="utf-8")
        if pictures:
            pathlib.Path(pictures, f"{file.stem}.png").write_bytes(last_picture(notebook))


if __name__ == "__main__":
    main(*sys.argv[1:])
