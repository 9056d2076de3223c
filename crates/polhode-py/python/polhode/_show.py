"""What shows a run: pages, pictures and plots, in notebooks and as files."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ._errors import ViewError

if TYPE_CHECKING:
    import os
    from pathlib import Path


class _Shown:
    """Bytes that a notebook shows and a file keeps."""

    __slots__ = ("data", "name")
    _ending: ClassVar[str]

    def __init__(self, name: str, data: bytes) -> None:
        #: Name of the scene.
        self.name = name
        #: What a file of it holds.
        self.data = data

    @classmethod
    def place(cls, path: str | os.PathLike[str]) -> Path:
        """The path of a file that may hold it, by its ending."""
        from pathlib import Path

        file = Path(path)
        if file.suffix.lower() != cls._ending:
            raise ViewError(f"{file}: the file of a {cls.__name__} ends in {cls._ending}")
        return file

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes it to a file, and gives the path."""
        file = self.place(path)
        file.write_bytes(self.data)
        return file

    def __repr__(self) -> str:
        kind = type(self).__name__
        return f"<polhode.{kind} of {self.name!r}: {len(self.data)} bytes, save(path) writes them as {self._ending}>"


class Page(_Shown):
    """A page that plays a run, without a network; :meth:`polhode.Run.page` makes it.

    >>> import polhode as ph
    >>> scene = ph.Scene(name="ball", duration=0.1)
    >>> ball = scene.add(ph.Sphere(0.1), mass=1.0)
    >>> page = ph.run(scene).page()
    >>> page.html.startswith("<!doctype html>"), page._repr_html_().startswith("<iframe srcdoc=")
    (True, True)
    """

    __slots__ = ()
    _ending = ".html"

    @property
    def html(self) -> str:
        """Its text."""
        return self.data.decode()

    def open(self) -> Path:
        """Writes it to a temporary file, which a browser opens, and gives the path."""
        import tempfile
        import webbrowser
        from pathlib import Path

        name = "".join(letter if letter.isalnum() else "-" for letter in self.name)
        with tempfile.NamedTemporaryFile(prefix=f"{name}-", suffix=self._ending, delete=False) as file:
            file.write(self.data)
        path = Path(file.name)
        if not webbrowser.open(path.as_uri()):
            raise ViewError(f"{path}: no browser can be opened: open this page in one, or give view() a path")
        return path

    def _repr_html_(self) -> str:
        source = self.html.replace("&", "&amp;").replace('"', "&quot;")
        style = "width: 100%; height: 600px; border: 0"
        return f'<iframe srcdoc="{source}" style="{style}" title="{_quoted(self.name)}" allow="fullscreen"></iframe>'


class Still(_Shown):
    """A run at one time, as a picture; :meth:`polhode.Run.still` makes it."""

    __slots__ = ()
    _ending = ".png"

    def _repr_png_(self) -> bytes:
        return self.data


class Gif(_Shown):
    """A run as a moving picture; :meth:`polhode.Run.gif` makes it."""

    __slots__ = ()
    _ending = ".gif"

    def _repr_html_(self) -> str:
        import base64

        data = base64.b64encode(self.data).decode()
        return f'<img src="data:image/gif;base64,{data}" alt="{_quoted(self.name)}">'


class Plot(_Shown):
    """Quantities of a run over time; :meth:`polhode.Run.plot` makes it."""

    __slots__ = ()
    _ending = ".svg"

    @property
    def svg(self) -> str:
        """Its text."""
        return self.data.decode()

    def _repr_svg_(self) -> str:
        return self.svg


def _quoted(text: str) -> str:
    import html

    return html.escape(text)
