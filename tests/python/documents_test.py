"""docs/python.md and docs/lecture.ipynb show what the module answers."""

import doctest
import pathlib

import pytest

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


def test_the_page_shows_real_output():
    result = doctest.testfile(str(DOCS / "python.md"), module_relative=False,
                              optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert result.attempted > 10 and result.failed == 0


def texts(notebook):
    return [output.get("text") for cell in notebook.cells for output in cell.get("outputs", [])
            if output.get("text")]


def test_the_notebook_is_as_executed():
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    notebook = nbformat.read(DOCS / "lecture.ipynb", 4)
    shown = texts(notebook)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    assert texts(notebook) == shown and len(shown) == 5
