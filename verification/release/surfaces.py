"""The five surfaces that are stable within a major version (docs/reference/stability.md), as the present program has them.

Every function returns {name: detail}. The name identifies an option, a key, a field, a declaration; the detail is the rest of
what users depend on: the kind of a value, its default, the types of arguments.
"""

import importlib
import inspect
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def output(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"stability: exit code {done.returncode} of {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout


def help_rows(text):
    """{name: detail} of the lines of positionals and options in the help of a command."""
    rows, inside = {}, False
    for line in text.split("\n"):
        if line and not line.startswith(" "):
            inside = line in ("Positionals:", "Options:")
        elif inside and re.match(r"  \S", line):
            names, _, value = re.split(r" {2,}", line.strip())[0].partition(" ")
            # Which options exclude each other is not listed: fewer exclusions are compatible.
            value = re.sub(r" ?\b(Excludes|Needs): .*", "", value)
            name = re.sub(r"^-\w,", "", names)
            rows[name] = " ".join(word for word in (names if name != names else "", value) if word)
    return rows


def commands(program):
    """Commands, options and their values, and exit codes, from --help."""
    text = output(program, "--help")
    names = re.findall(r"(?m)^  (\w+) {2,}\S", text.split("Subcommands:")[1])
    rows = {f"tdbd {name}": detail for name, detail in help_rows(text).items()}
    for name in names:
        rows[f"tdbd {name}"] = ""
        rows |= {f"tdbd {name} {option}": detail for option, detail in help_rows(output(program, name, "--help")).items()}
    codes = re.search(r"(?m)^Exit codes: (.*)\.$", text).group(1)
    return rows | {f"exit code {code}": meaning for code, meaning in re.findall(r"(\d+) ([^,]+)", codes)}


def table_rows(text):
    """{name: detail} of the keys that `tdbd keys --markdown` prints: kind, default and allowed values, without the meaning."""
    rows, table = {}, ""
    for line in text.split("\n"):
        heading = re.match(r"## `([^`]*)` of `tdbd (\w+)`", line)
        if heading:
            table = f"{heading.group(2)} {heading.group(1)}"
        elif line.startswith("| `"):
            key, kind, default, allowed = (cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:5])
            rows[f"{table} {key.strip('`')}"] = "; ".join(part for part in (kind, f"default {default}" if default else "", allowed) if part)
    return rows


def settings(program):
    """All keys of input files and the columns of a cutter table."""
    rows = table_rows(output(program, "keys", "--markdown")) | table_rows(output(program, "keys", "--design", "--markdown"))
    for line in output(program, "keys", "cutter-table").split("\n"):
        cells = re.split(r" {2,}", line.strip())
        if line.startswith("  ") and len(cells) > 3:
            rows[f"bit [cutter-table] {cells[0]}"] = f"{cells[1]}; default {cells[2]}"
    return rows


# Runs that together write all fields: {folder: words of the command}.
COARSE = ["--set", "rock.edge_length=8 mm", "--quiet"]
PART_OF_TURN = [*COARSE, "--set", "time.revolutions=0.1", "--set", "output.means_from=0.01 s"]
MOMENT = [*COARSE, "--set", "time.duration=0.03 s", "--set", "output.means_from=0.005 s"]
RESULTS = {
    "run": [["run", "cases/bit-b-6000psi.toml", *PART_OF_TURN], ["run", "cases/drill-bit-b.toml", *MOMENT],
            ["run", "cases/drill-bit-r.toml", *MOMENT],
            ["run", "cases/string-drill-bit-b.toml", *MOMENT], ["run", "cases/wear-bit-b.toml", *PART_OF_TURN]],
    "rotate": [["rotate", "cases/slow-top.toml", "--quiet", "--set", "time.duration=0.05 s"],
               ["rotate", "cases/free-rotation/asymmetric-spinning.toml", "--quiet", "--set", "time.duration=1 s"]],
    "string": [["string", "cases/string-vertical-2500.toml", "--quiet", "--set", "time.duration=0.05 s"]],
    "calibrate": [["calibrate", "validation/cases/zijsling-share.toml", "--quiet"]],
    "converge": [["converge", "cases/slow-top.toml", "--over", "time.step", "--levels", "3", "--quiet"]],
    "bit": [["bit", "cases/bits/standard.toml", "--report", "--quiet"]],
}
# Numbers of events and times depend on the implementation.
NOT_STABLE = ("counters", "timing.json", "checkpoint", "history.rows")
BY_NAME = ("coefficients", "variables", "weakest_direction", "by_bit")


def fields(value, name=""):
    """{name: kind} of a JSON value. Elements of lists are [], and keys that are names of parts are *."""
    if isinstance(value, dict):
        rows = {}
        for key, one in value.items():
            own = "*" if not re.fullmatch(r"[a-z][a-z0-9_]*", key) or name.split(".")[-1] in BY_NAME else key
            if own not in NOT_STABLE:
                merge(rows, fields(one, f"{name}.{own}" if name else own))
        return rows
    if isinstance(value, list):
        rows = {}
        for one in value:
            merge(rows, fields(one, name + "[]"))
        return rows or {name + "[]": "null"}
    kinds = {type(None): "null", bool: "true or false", str: "text"}
    return {name: kinds.get(type(value), "number")}


def merge(rows, more):
    """Adds fields. A field that is null in one result and has a value in another one has the kind of the value."""
    for name, kind in more.items():
        if rows.get(name, "null") == "null":
            rows[name] = kind


def file_fields(file):
    """The fields of a file of results: JSON, the header of a CSV, the variables of NetCDF."""
    import json
    import netCDF4
    if file.suffix == ".json":
        return fields(json.loads(file.read_text(encoding="utf-8")))
    if file.suffix == ".csv":
        header = file.read_text(encoding="utf-8").split("\n", 1)[0]
        return {f"column {name}": "" for name in header.split(",")}
    with netCDF4.Dataset(file) as data:
        return {f"variable {name}": f"({', '.join(v.dimensions)}) {getattr(v, 'units', '')}".strip() for name, v in data.variables.items()}


def results(program):
    """Files of the results of all commands, with their fields."""
    rows = {}
    with tempfile.TemporaryDirectory() as work:
        for command, runs in RESULTS.items():
            for number, words in enumerate(runs):
                folder = Path(work) / f"{command}-{number}"
                output(program, *words, "-o", folder, cwd=ROOT)
                for file in sorted(path for path in folder.iterdir() if path.is_file() and not path.name.startswith(NOT_STABLE)):
                    rows.setdefault(f"{command} {file.name}", "")
                    if file.suffix in (".json", ".csv", ".nc"):
                        merge(rows, {f"{command} {file.name} {name}": kind for name, kind in file_fields(file).items()})
    return rows


def text_of(node):
    return " ".join("".join(node.itertext()).split()) if node is not None else ""


def member_row(owner, member):
    """(name, detail) of a function, variable, type or enumeration."""
    kind, name = member.get("kind"), f"{owner}::{member.findtext('name')}"
    if kind == "enum":
        return f"enum {name}", ", ".join(value.findtext("name") for value in member.findall("enumvalue"))
    types = [text_of(parameter.find("type")) + (" = ..." if parameter.find("defval") is not None else "") for parameter in member.findall("param")]
    if kind == "function":
        constant = " const" if member.get("const") == "yes" else ""
        return f"function {name}({', '.join(types)}){constant}", text_of(member.find("type"))
    return f"{'type' if kind == 'typedef' else 'variable'} {name}", text_of(member.find("type"))


def headers(_):
    """The declarations of the public headers, as Doxygen reads them. Names of arguments are not part of it."""
    listed = [line for line in (ROOT / "src/public_headers.txt").read_text(encoding="utf-8").split("\n") if line and not line.startswith("#")]
    rows = {f"header {header}": "" for header in listed}
    with tempfile.TemporaryDirectory() as folder:
        own = {"INPUT": " ".join(f"src/{header}" for header in listed), "OUTPUT_DIRECTORY": folder, "GENERATE_HTML": "NO", "GENERATE_XML": "YES",
               "XML_PROGRAMLISTING": "NO", "USE_MDFILE_AS_MAINPAGE": "", "WARNINGS": "NO", "WARN_AS_ERROR": "NO"}
        base = (ROOT / "reports/api/Doxyfile").read_text(encoding="utf-8")
        output("doxygen", "-", input=base + "".join(f"{key} = {value}\n" for key, value in own.items()), cwd=ROOT)
        for file in sorted(Path(folder, "xml").glob("*.xml")):
            for compound in ElementTree.parse(file).getroot().findall("compounddef"):
                owner = compound.findtext("compoundname")
                if compound.get("kind") not in ("struct", "class", "namespace") or "detail" in owner or "@" in owner:
                    continue
                if compound.get("kind") != "namespace":
                    rows[f"{compound.get('kind')} {owner}"] = ""
                for member in compound.iter("memberdef"):
                    if member.get("prot") == "public" and member.findtext("name") and "@" not in member.findtext("name"):
                        name, detail = member_row(owner, member)
                        rows[name] = detail
    return rows


def signature(value):
    """Arguments and defaults, without annotations."""
    try:
        found = inspect.signature(value)
    except (TypeError, ValueError):
        return ""
    bare = [p.replace(annotation=inspect.Parameter.empty) for p in found.parameters.values() if p.name != "self"]
    return str(found.replace(parameters=bare, return_annotation=inspect.Signature.empty))


def class_rows(name, kind):
    bases = ", ".join(base.__name__ for base in kind.__mro__[1:-1] if not base.__name__.startswith("_"))
    made = signature(kind) if "__init__" in vars(kind) or "__new__" in vars(kind) else ""
    rows = {f"class {name}": "; ".join(part for part in (bases, made) if part)}
    for own, member in vars(kind).items():
        if not own.startswith("_"):
            member = getattr(member, "__func__", member)
            kind_of = "function" if inspect.isfunction(member) else "attribute"
            rows[f"{kind_of} {name}.{own}"] = signature(member) if kind_of == "function" else ""
    for own in getattr(kind, "__annotations__", {}):
        if not own.startswith("_"):
            rows.setdefault(f"attribute {name}.{own}", "")
    return rows


def python(packages):
    """The public names of the Python package, with arguments and defaults."""
    sys.path.insert(0, str(packages))
    rows = {}
    for module in ("tdbd", "tdbd.bit", "tdbd.mesh", "tdbd.sweep"):
        found = importlib.import_module(module)
        public = getattr(found, "__all__", None) or [name for name, value in vars(found).items()
                                                     if not name.startswith("_") and getattr(value, "__module__", "") == module]
        rows[f"module {module}"] = ""
        for name in public:
            value = getattr(found, name)
            if inspect.isclass(value):
                rows |= class_rows(f"{module}.{name}", value)
            elif not inspect.ismodule(value):
                rows[f"{'function' if callable(value) else 'attribute'} {module}.{name}"] = signature(value) if callable(value) else ""
    return rows
