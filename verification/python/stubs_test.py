"""The type stubs (_core.pyi) list the names of the compiled module, every public name has a docstring, and arrays state their shape."""

import ast
import inspect
import re
import unittest

from common import ROOT

import tdbd
from tdbd import _core

STUBS = ast.parse((ROOT / "python/tdbd/_core.pyi").read_text(encoding="utf-8"))


def stubbed(body):
    """{name: node} of functions, classes and variables."""
    named = {node.name: node for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    return named | {node.target.id: node for node in body if isinstance(node, ast.AnnAssign)}


def words_of(node):
    return [a.arg for a in node.args.args if a.arg != "self"]


def words_in(docstring):
    """Names of the arguments in the first line that pybind11 writes: "run(case: ..., folder: str) -> ..."."""
    head = docstring.split("\n")[0].split(" -> ")[0]
    return [word for word in re.findall(r"(\w+): ", head) if word != "self"]


class Stubs(unittest.TestCase):
    def test_the_module(self):
        own = {name for name in vars(_core) if not name.startswith("__")}
        self.assertEqual(set(stubbed(STUBS.body)), own)

    def test_classes(self):
        for name, node in stubbed(STUBS.body).items():
            if isinstance(node, ast.ClassDef):
                own = {n for n in vars(getattr(_core, name)) if not n.startswith("_") or n in ("__enter__", "__exit__")}
                self.assertEqual(set(stubbed(node.body)) - {"__init__"}, own, name)

    def test_arguments(self):
        functions = [(name, node) for name, node in stubbed(STUBS.body).items() if isinstance(node, ast.FunctionDef)]
        self.assertGreater(len(functions), 15)
        for name, node in functions:
            self.assertEqual(words_of(node), words_in(getattr(_core, name).__doc__), name)
        for kind in ("Drilling", "Rotating", "StudyWords"):
            for name, node in stubbed(next(n for n in STUBS.body if getattr(n, "name", "") == kind).body).items():
                if isinstance(node, ast.FunctionDef) and not any(getattr(d, "id", "") == "property" for d in node.decorator_list):
                    self.assertEqual(words_of(node), words_in(getattr(getattr(_core, kind), name).__doc__), (kind, name))

    def test_modules(self):
        """Every public function and class of the modules has a docstring."""
        for module in (tdbd.bit, tdbd.mesh, tdbd.sweep):
            for name, found in vars(module).items():
                if name.startswith("_") or getattr(found, "__module__", "") != module.__name__:
                    continue
                self.assertTrue(found.__doc__, name)
                for own, member in vars(found).items() if inspect.isclass(found) else ():
                    if not own.startswith("_") and inspect.isfunction(member) or type(member) is property:
                        self.assertTrue(member.__doc__, (name, own))

    def test_docstrings(self):
        for name in tdbd.__all__:
            found = getattr(tdbd, name)
            if name not in ("provenance", "FilesLock"):
                self.assertTrue(found.__doc__, name)
            if inspect.isclass(found) and not issubclass(found, (Exception, tuple)):
                for own, member in vars(found).items():
                    if not own.startswith("_") and callable(member) or isinstance(member, property):
                        self.assertTrue(member.__doc__, (name, own))

    def test_shapes(self):
        for kind in (_core.Drilling, _core.Rotating):
            arrays = [p for p in vars(kind).values() if isinstance(p, property) and "numpy.ndarray" in (p.fget.__doc__ or "")]
            self.assertGreater(len(arrays), 5)
            for member in arrays:
                self.assertRegex(member.__doc__, r"^\([\w, ]+\) ", member.__doc__)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
