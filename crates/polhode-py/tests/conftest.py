"""What tests share: shipped scenes, and the program."""

import os
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
SCENES = ROOT / "fixtures" / "scenes"


@pytest.fixture
def program() -> Path:
    """The program, as `cargo build` leaves it; POLHODE names another one."""
    named = os.environ.get("POLHODE")
    built = Path(named) if named else ROOT / "target" / "debug" / "polhode"
    if not built.exists():
        found = shutil.which("polhode")
        if found is None:
            pytest.skip("the program polhode is not built: cargo build")
        built = Path(found)
    return built
