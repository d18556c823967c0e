"""Configuration of the documentation site. scripts/docs stages the pages (docs/tools/stage.py) and calls Sphinx."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import furo
from sphinx.util import logging

ROOT = Path(os.environ["TDBD_ROOT"])
sys.path.insert(0, os.environ.get("TDBD_PYTHON_PACKAGE", str(ROOT / "build/release/python")))

project = "TDBD"
author = "the TDBD authors"
copyright = "the TDBD authors, GPL-3.0-or-later"
version = release = re.search(r"(?m)^project\(TDBD VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)

extensions = ["myst_parser", "sphinx.ext.autodoc", "docs_equations"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_dmath_allow_space = False
myst_heading_anchors = 3
suppress_warnings = ["myst.header"]
exclude_patterns = ["README.md"]
source_suffix = {".md": "markdown"}
autodoc_member_order = "bysource"
autodoc_typehints = "none"
default_role = "code"
highlight_language = "none"
smartquotes = False  # quotation marks in tables are part of settings

html_theme = "furo"
html_title = f"TDBD {version}"
html_static_path = ["static"]
html_css_files = ["katex/katex.min.css", "tdbd.css"]
html_extra_path = ["extra"]
html_copy_source = False
html_show_sphinx = False
# Browsers do not let a page that was opened from disk read other files.
html_show_search_summary = False


def dark_colours():
    """The colours of the dark theme. The style sheet of Debian's Furo applies them only after a click on the button of the theme, not
    if the browser prefers a dark page; as options of the theme they apply in both cases."""
    style = Path(furo.__file__).parent / "theme/furo/static/styles/furo.css"
    block = re.search(r'body\[data-theme="dark"\]\s*\{([^}]*)\}', style.read_text(encoding="utf-8"))
    return {name: value.strip() for name, value in re.findall(r"--([\w-]+):([^;]*)", block.group(1))} if block else {}


html_theme_options = {"navigation_with_keys": True, "dark_css_variables": dark_colours()}


class Equations:
    """One process that converts all equations."""

    def __init__(self):
        self.process = None

    def html(self, tex, display):
        if self.process is None:
            self.process = subprocess.Popen(["node", str(ROOT / "docs/tools/equations.js")], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


equations = Equations()


def write_equation(translator, node, display):
    from docutils import nodes
    answer = equations.html(node.astext(), display)
    if "error" in answer:
        logging.getLogger(__name__).warning("the equation %r is wrong: %s", node.astext(), answer["error"], location=node)
    number = f'<span class="eqno">({node["number"]})</span>' if display and node.get("number") else ""
    tag = "div" if display else "span"
    translator.body.append(f'<{tag} class="equation">{number}{answer.get("html", "")}</{tag}>')
    raise nodes.SkipNode


def add_equations(app):
    app.add_html_math_renderer("katex", (lambda t, n: write_equation(t, n, False), None), (lambda t, n: write_equation(t, n, True), None))


# The renderer is an extension of its own so that Sphinx knows it before it reads html_math_renderer.
module = type(sys)("docs_equations")
module.setup = lambda app: add_equations(app) or {"parallel_read_safe": True}
sys.modules["docs_equations"] = module
html_math_renderer = "katex"


def copy_katex(app, _):
    """Copies the style sheet and the fonts of the equations into the site."""
    if app.builder.format != "html":
        return
    target = Path(app.outdir) / "_static/katex"
    (target / "fonts").mkdir(parents=True, exist_ok=True)
    shutil.copy("/usr/share/javascript/katex/katex.min.css", target)
    for font in Path("/usr/share/fonts/truetype/katex").glob("*.woff2"):
        shutil.copy(font, target / "fonts")


def literal_examples(app, what, name, obj, options, lines):
    """Docstrings show examples as indented lines; the markup needs a mark before them."""
    if what == "module":  # autodoc removed the indentation if all lines but the first are an example
        lines[:] = obj.__doc__.split("\n")
    for i in range(len(lines) - 1, 0, -1):
        if lines[i].startswith("    ") and not lines[i - 1].strip() and (i < 2 or not lines[i - 2].startswith("    ")):
            lines[i:i] = ["::", ""]


def setup(app):
    app.connect("autodoc-process-docstring", literal_examples)
    app.connect("build-finished", copy_katex)
