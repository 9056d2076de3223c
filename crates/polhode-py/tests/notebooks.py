"""Executes each notebook from its start to its end: ``python -m tests.notebooks``, or with the paths of some."""

import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).resolve().parents[1] / "notebooks"
#: How long a cell may take, s.
PATIENCE = 300


def main(paths: list[str]) -> None:
    notebooks = [Path(path) for path in paths] or sorted(FOLDER.glob("*.ipynb"))
    assert notebooks, f"no notebook is in {FOLDER}"
    for path in notebooks:
        begun = time.monotonic()
        notebook = nbformat.read(path, as_version=4)
        nbformat.validate(notebook)
        where = {"metadata": {"path": str(path.parent)}}
        NotebookClient(notebook, timeout=PATIENCE, kernel_name="python3", resources=where).execute()
        print(f"{path.name}: {time.monotonic() - begun:.1f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
