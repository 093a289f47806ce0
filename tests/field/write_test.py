"""`./run field --write NAME` writes the page and the row of this engine, and leaves the other pages as they are."""
import difflib
import pathlib
import shutil
import sys
import tempfile
import tomllib
import unittest

SOURCE = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(SOURCE / "examples/engines"))
import tables  # noqa: E402


class Page:
    """A page of an engine whose rows and text are made up."""

    def __init__(self, name):
        self.title = name

    def row(self):
        return [f"[A library](field/{self.title}.md)", "`f(a | b)`", "holds", *["-"] * (len(tables.HEAD) - 3)]

    def text(self):
        return "a new page\n"


class Write(unittest.TestCase):
    def written(self, *names, others=True):
        """The lines of field.md that disappear and appear, and the pages that change, when pages of these names are written."""
        engines = tomllib.loads((SOURCE / "examples/engines/engines.toml").read_text())["engine"]
        engines = [{"name": name} for name in ("quadratic", "cross", "robust")] + engines
        with tempfile.TemporaryDirectory() as folder:
            docs = pathlib.Path(folder)
            shutil.copytree(SOURCE / "docs/field", docs / "field")
            for name in ("field.md", "field.in.md"):
                shutil.copy(SOURCE / "docs" / name, docs)
            tables.write([], engines, docs, True)  # with field.in.md of now
            before = (docs / "field.md").read_text().splitlines()
            tables.write([Page(name) for name in names], engines, docs, others)
            lines = list(difflib.ndiff(before, (docs / "field.md").read_text().splitlines()))
            old, new = (SOURCE / "docs/field", docs / "field")
            pages = {page.stem for page in [*old.glob("*.md"), *new.glob("*.md")]}
            differ = {name for name in pages if not (new / f"{name}.md").exists() or not (old / f"{name}.md").exists()
                      or (new / f"{name}.md").read_text() != (old / f"{name}.md").read_text()}
        return [line for line in lines if line[0] == "-"], [line for line in lines if line[0] == "+"], differ

    def test_a_row_is_replaced(self):
        gone, come, pages = self.written("three")
        self.assertEqual(pages, {"three"})
        self.assertEqual([line.split("](")[1].split(")")[0] for line in gone], ["field/three.md"])
        self.assertIn("(field/three.md) | `f(a \\| b)` | holds", come[0])
        self.assertEqual(len(come), 1)

    def test_nothing_changes_if_no_page_is_written(self):
        self.assertEqual(self.written(), ([], [], set()))

    def test_a_run_without_names_deletes_other_pages(self):
        _, _, pages = self.written("three", others=False)
        self.assertGreater(len(pages), 70)

    def test_a_row_is_inserted_in_the_order_of_the_engines(self):
        first, second = "cgal-ray", "three"
        text = (SOURCE / "docs/field.md").read_text()
        without = "\n".join(line for line in text.splitlines() if f"(field/{second}.md)" not in line)
        with tempfile.TemporaryDirectory() as folder:
            docs = pathlib.Path(folder)
            (docs / "field.md").write_text(without)
            shutil.copy(SOURCE / "docs/field.in.md", docs)
            tables.write([Page(second)], [{"name": first}, {"name": second}, {"name": "yuka"}], docs, True)
            self.assertEqual(list(tables.rows_of((docs / "field.md").read_text())), [first, second, "yuka"])


if __name__ == "__main__":
    unittest.main()
