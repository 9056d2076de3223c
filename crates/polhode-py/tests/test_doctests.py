"""The examples in docstrings and README run as they stand."""

import doctest
import importlib
import pkgutil
from pathlib import Path

import polhode
import pytest

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
MODULES = ["polhode", *(f"polhode.{module.name}" for module in pkgutil.iter_modules(polhode.__path__))]


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name):
    results = doctest.testmod(importlib.import_module(name), optionflags=FLAGS)
    assert results.failed == 0


def test_readme():
    text = (Path(__file__).resolve().parents[1] / "README.md").read_text()
    blocks = [part.split("```")[0] for part in text.split("```python")[1:]]
    assert len(blocks) >= 2
    for block in blocks:
        exec(compile(block, "README.md", "exec"), {})
