"""Answers in words, with their data and their pages."""

from __future__ import annotations

import functools
import html
import os
import typing
from collections.abc import Callable


def framed(page: str) -> str:
    """A page in a frame of its own, so that the styles of a notebook and of the page leave each other alone. Its lower corner
    pulls it longer."""
    box = "height: 45rem; resize: vertical; overflow: hidden; border: 1px solid #8888"
    return f'<div style="{box}"><iframe srcdoc="{html.escape(page)}" style="width: 100%; height: 100%; border: 0"></iframe></div>'


class Answer:
    """An answer in words, ``title``, with what it rests on: ``data`` as the command writes it with ``--json``, and the page of
    the command, which notebooks show and :meth:`save` writes.

    ``card`` is the material card that a fit has made, a text; else None."""

    def __init__(self, title: str, data: dict[str, typing.Any], page: str | Callable[[], str]):
        self.title = title
        self.data = data
        self.card: str | None = None
        self._page = page

    @functools.cached_property
    def page(self) -> str:
        """The page of the answer, one HTML document that needs no other files."""
        return self._page if isinstance(self._page, str) else self._page()

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the page as an HTML file; FileExistsError if there is one of that name."""
        with open(file, "x", encoding="utf-8") as written:
            written.write(self.page)

    def __repr__(self) -> str:
        return f"<dashpad.Answer: {self.title}>"

    def _repr_html_(self) -> str:
        return framed(self.page)
