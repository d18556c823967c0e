#!/usr/bin/python3
"""Executes the notebooks and stores their outputs, without Jupyter.

    PYTHONPATH=build/release/python /usr/bin/python3 python/notebooks/execute.py [NOTEBOOK.ipynb ...]

The cells run one after another in one namespace, in the folder of the notebook. Printed text, the value of the last
expression and figures become the outputs of a cell. The test python.notebooks executes the cells again and compares
the texts, except those of cells with the tag "varies", whose output depends on the machine.
"""

import ast
import base64
import contextlib
import io
import json
import os
import sys
import warnings
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

DOTS = 60  # per inch: readable in a notebook, and small enough to be kept in the repository


def _lines(text):
    """Text as a notebook stores it: a list of lines that keep their ends."""
    return text.splitlines(keepends=True)


def _shown(value):
    """The data of a cell's last value: a picture of a figure, otherwise its repr."""
    data = {"text/plain": _lines(repr(value))}
    if hasattr(value, "savefig"):
        picture = io.BytesIO()
        value.savefig(picture, format="png", dpi=DOTS, metadata={"Software": None})
        data = {"image/png": base64.b64encode(picture.getvalue()).decode(), "text/plain": ["<Figure>"]}
    return data


def run_cell(text, name, names):
    """Executes statements; returns the printed text and the data of the last expression, or None."""
    tree = ast.parse(text, name)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, name, "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), name, "eval"), names)
    return printed.getvalue(), None if value is None else _shown(value)


def outputs_of(printed, data, count):
    """The outputs of a code cell, as in the format nbformat 4."""
    outputs = []
    if printed:
        outputs.append({"name": "stdout", "output_type": "stream", "text": _lines(printed)})
    if data:
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def executed(path):
    """The notebook with the outputs of all cells."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    names, before = {"__name__": "__main__"}, os.getcwd()
    os.chdir(path.parent)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            code = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
            for count, cell in enumerate(code, 1):
                printed, data = run_cell("".join(cell["source"]), f"{path.name}, code cell {count}", names)
                cell["execution_count"], cell["outputs"] = count, outputs_of(printed, data, count)
    finally:
        os.chdir(before)
    return notebook


def texts(cell):
    """The texts among the outputs of a cell."""
    return ["".join(output.get("text") or output["data"]["text/plain"]) for output in cell["outputs"]]


def varies(cell):
    """Whether the outputs of a cell depend on the machine."""
    return "varies" in cell["metadata"].get("tags", [])


if __name__ == "__main__":
    chosen = [Path(word).resolve() for word in sys.argv[1:]]
    for one in chosen or sorted(Path(__file__).resolve().parent.glob("*.ipynb")):
        text = json.dumps(executed(one), indent=1, ensure_ascii=False) + "\n"
        one.write_text(text, encoding="utf-8")
        print(f"{one.name}: {len(text) // 1024} kB")
