"""Every notebook runs from its first cell to its last, in its own folder, and is kept without outputs.

The cells are run here, one after another in one namespace: that takes no Jupyter.
"""

import ast
import contextlib
import io
import json
import os
import unittest

from common import ROOT

import matplotlib

matplotlib.use("Agg")
NOTEBOOKS = sorted((ROOT / "python/notebooks").glob("*.ipynb"))


def source(cell):
    return "".join(cell["source"])


def shown(value):
    """What a notebook would show of a cell's last value: a picture is drawn, all else printed."""
    if hasattr(value, "savefig"):
        value.savefig(io.BytesIO(), format="png")
    return repr(value)


def run_cell(text, name, names):
    """Statements, and the value of a last expression."""
    tree = ast.parse(text, name)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, name, "exec"), names)
    if last is not None:
        return shown(eval(compile(ast.Expression(last.value), name, "eval"), names))
    return ""


def run_notebook(path):
    """What the code cells print and show."""
    cells = [cell for cell in json.loads(path.read_text(encoding="utf-8"))["cells"] if cell["cell_type"] == "code"]
    names, printed = {"__name__": "__main__"}, io.StringIO()
    os.chdir(path.parent)
    with contextlib.redirect_stdout(printed):
        values = [run_cell(source(cell), f"{path.name}, code cell {i}", names) for i, cell in enumerate(cells, 1)]
    return printed.getvalue() + "\n".join(values)


class Notebooks(unittest.TestCase):
    def test_all_run(self):
        self.assertGreaterEqual(len(NOTEBOOKS), 3)
        for path in NOTEBOOKS:
            with self.subTest(path.name):
                before = sorted(path.parent.iterdir())
                self.assertGreater(len(run_notebook(path)), 100)
                self.assertEqual(sorted(path.parent.iterdir()), before)

    def test_a_cell_that_fails_is_seen(self):
        self.assertEqual(run_cell("a = 1\na + 1", "cell", {}), "2")
        self.assertRaises(AssertionError, run_cell, "assert 1 == 2", "cell", {})
        self.assertRaises(ZeroDivisionError, run_cell, "1 / 0", "cell", {})

    def test_they_are_kept_as_they_begin(self):
        for path in NOTEBOOKS:
            cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
            self.assertEqual(cells[0]["cell_type"], "markdown", path)
            for cell in cells:
                if cell["cell_type"] == "code":
                    self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), path)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
