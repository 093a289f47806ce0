"""Runs a file of tests here by pytest; exits with 77 if pytest or Hypothesis is not installed."""

import pathlib
import sys

try:
    import hypothesis  # noqa: F401
    import numpy  # noqa: F401
    import pytest
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider",
                      str(pathlib.Path(__file__).parent / sys.argv[1])]))
