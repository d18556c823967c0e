"""The public headers' docstrings have no unknown command, tag or reference: Doxygen reads them without a warning.

A remark about a whole header begins with "/// @file": Doxygen would take it for part of the next docstring.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def loose_remarks(text):
    """Lines of docstrings at the left margin before an empty line, which document nothing."""
    lines = text.split("\n")
    found = []
    for i, line in enumerate(lines):
        starts = line.startswith("///") and not (i > 0 and lines[i - 1].startswith("///"))
        end = i
        while starts and end < len(lines) and lines[end].startswith("///"):
            end += 1
        if starts and not line.startswith("/// @file") and end < len(lines) and not lines[end].strip():
            found.append(i + 1)
    return found


def warnings_of(folder, settings):
    """The warnings of Doxygen with the settings of the Doxyfile and these."""
    base = (ROOT / "reports/api/Doxyfile").read_text(encoding="utf-8")
    own = {"OUTPUT_DIRECTORY": folder, "GENERATE_HTML": "NO", "GENERATE_XML": "YES", "XML_PROGRAMLISTING": "NO", **settings}
    text = base + "".join(f"{key} = {value}\n" for key, value in own.items())
    done = subprocess.run(["doxygen", "-"], input=text, text=True, cwd=ROOT, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE)
    told = list(dict.fromkeys(done.stderr.replace(f"{ROOT}/", "").splitlines()))
    return told or ([f"doxygen: exit code {done.returncode}"] if done.returncode else [])


def self_test(folder):
    bad = pathlib.Path(folder) / "bad.hpp"
    bad.write_text("/// @file\n/// Of the file.\n\n/// A \\notacommand, a <tag> and @ref nowhere.\nint f();\n", encoding="utf-8")
    told = warnings_of(folder, {"INPUT": folder})
    assert len(told) == 3, told
    assert not loose_remarks(bad.read_text(encoding="utf-8"))
    assert loose_remarks("#pragma once\n\n/// Of the file,\n/// told twice.\n\n/// Of f.\nint f();\n") == [3]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--self-test", action="store_true")
    with tempfile.TemporaryDirectory() as folder:
        if parser.parse_args().self_test:
            return self_test(folder)
        problems = warnings_of(folder, {})
    for header in sorted((ROOT / "src").rglob("*.hpp")):
        for line in loose_remarks(header.read_text(encoding="utf-8")):
            problems.append(f"{header.relative_to(ROOT)}:{line}: a remark about the file without @file")
    print("\n".join(problems))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
