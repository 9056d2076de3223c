"""The examples in docstrings and README run as they stand."""

import doctest
import importlib.util
import pkgutil
from pathlib import Path

import polhode
import pytest

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
MODULES = ["polhode", *(f"polhode.{module.name}" for module in pkgutil.iter_modules(polhode.__path__))]


@pytest.mark.parametrize("name", MODULES)
def test_docstrings(name):
    if name == "polhode.gym":
        pytest.importorskip("gymnasium")
    results = doctest.testmod(importlib.import_module(name), optionflags=FLAGS)
    assert results.failed == 0


ROOT = Path(__file__).resolve().parents[3]


@pytest.mark.parametrize("page", ["crates/polhode-py/README.md", "README.md", "docs/book/python.md"])
def test_pages(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    blocks = [part.split("```")[0] for part in text.split("```python")[1:]]
    own = [block for block in blocks if "import polhode" in block]
    assert own
    for block in own:
        if "import gymnasium" in block and importlib.util.find_spec("gymnasium") is None:
            continue
        exec(compile(block, page, "exec"), {})
