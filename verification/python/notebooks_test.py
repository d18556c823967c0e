"""Every notebook runs from its first cell to its last, in its own folder, with the outputs that are stored in it. The examples
of python/README.md run, too.

execute.py beside the notebooks runs the cells one after another in one namespace: that takes no Jupyter.
"""

import base64
import doctest
import importlib.util
import json
import os
import re
import unittest

from common import ROOT, FolderTest

import tdbd

FOLDER = ROOT / "python/notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
ABSOLUTE_PATH = r"(?<![\w/:.])/\w[\w.-]*/"  # it would depend on the machine
loader = importlib.util.spec_from_file_location("execute", FOLDER / "execute.py")
execute = importlib.util.module_from_spec(loader)
loader.loader.exec_module(execute)


def code_cells(notebook):
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


class Notebooks(unittest.TestCase):
    def test_all_have_the_outputs_of_this_version(self):
        self.assertGreaterEqual(len(NOTEBOOKS), 3)
        for path in NOTEBOOKS:
            with self.subTest(path.name):
                before = sorted(path.parent.iterdir())
                stored, now = json.loads(path.read_text(encoding="utf-8")), execute.executed(path)
                for kept, found in zip(code_cells(stored), code_cells(now)):
                    if not execute.varies(kept):
                        self.assertEqual(execute.texts(kept), execute.texts(found), "run python/notebooks/execute.py")
                    self.assertEqual(len(kept["outputs"]), len(found["outputs"]))
                self.assertEqual(sorted(path.parent.iterdir()), before)

    def test_outputs_are_stored(self):
        for path in NOTEBOOKS:
            cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
            self.assertEqual(cells[0]["cell_type"], "markdown", path)
            code = [cell for cell in cells if cell["cell_type"] == "code"]
            self.assertEqual([cell["execution_count"] for cell in code], list(range(1, len(code) + 1)), path)
            self.assertGreater(sum(bool(cell["outputs"]) for cell in code), len(code) // 2, path)
            pictures = [output["data"]["image/png"] for cell in code for output in cell["outputs"]
                        if "image/png" in output.get("data", {})]
            self.assertTrue(pictures, path)
            for picture in pictures:
                self.assertTrue(base64.b64decode(picture).startswith(b"\x89PNG"), path)
            for text in [text for cell in code for text in execute.texts(cell)]:
                self.assertNotRegex(text, ABSOLUTE_PATH, path)

    def test_a_cell_that_fails_is_seen(self):
        self.assertEqual(execute.run_cell("a = 1\nprint(a)\na + 1", "cell", {}), ("1\n", {"text/plain": ["2"]}))
        self.assertRaises(AssertionError, execute.run_cell, "assert 1 == 2", "cell", {})
        self.assertRaises(ZeroDivisionError, execute.run_cell, "1 / 0", "cell", {})


class Readme(FolderTest):
    def test_examples_run(self):
        """Lines after >>> run from the top of the project with out/ in a temporary folder; outputs are compared where shown."""
        (self.folder / "cases").symlink_to(ROOT / "cases")
        (self.folder / "validation").symlink_to(ROOT / "validation")
        os.chdir(self.folder)
        text = (ROOT / "python/README.md").read_text(encoding="utf-8")
        examples = "\n\n".join(re.findall(r"(?:^    .*\n)+", text, re.M))
        test = doctest.DocTestParser().get_doctest(examples, {"tdbd": tdbd}, "README.md", "README.md", 0)
        self.assertGreater(len(test.examples), 12)
        said = []
        doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE).run(test, out=said.append)
        self.assertEqual("".join(said), "")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
