"""The files, types and functions in the table of src/README.md (classes of the thesis and of TDBD) exist."""

import re
import sys

import sources

sys.path.insert(0, str(sources.ROOT / "reports"))
import class_table  # noqa: E402


def declares(text, name):
    """Whether a header declares a type or a function of this name."""
    code = sources.without_comments(text)
    return re.search(rf"\b(struct|class|enum class)\s+{name}\b|\b{name}\s*\(", code) is not None


def check_row(row, read):
    """Problems of one row; `read` gives a file's text, or None when there is none."""
    texts = {file: read(f"src/{file}") for file in row.files}
    problems = [f"src/README.md, row {row.figure}: no file src/{file}" for file, text in texts.items() if text is None]
    found = [text for text in texts.values() if text is not None]
    problems += [f"src/README.md, row {row.figure}: none of its files declares {name}" for name in row.names
                 if not any(declares(text, name) for text in found)]
    problems += [f"src/README.md, row {row.figure}: src/{file} declares none of its names" for file, text in texts.items()
                 if text is not None and not any(declares(text, name) for name in row.names)]
    return problems


def read_or_none(path):
    return sources.read(path) if (sources.ROOT / path).is_file() else None


def check_all():
    rows = class_table.rows(sources.ROOT)
    if len(rows) < 10:
        return [f"src/README.md: found {len(rows)} rows under '{class_table.HEAD}', expected at least 10"]
    return [p for row in rows for p in check_row(row, read_or_none)]


def self_test():
    files = {"src/a.hpp": "struct Bit {};  // struct Cone\nPose part_pose(int a);\n", "src/b.hpp": "enum class Kind { a };\n"}
    row = class_table.row_of("| B.1 | x | `Bit`, `part_pose`; `Kind` | `a.hpp`, `b.hpp` |")
    assert row.names == ("Bit", "part_pose", "Kind") and not check_row(row, files.get), row
    for wrong, words in {"| B.1 | x | `Cone` | `a.hpp` |": "none of its files declares Cone",
                         "| B.1 | x | `Bit` | `c.hpp` |": "no file src/c.hpp",
                         "| B.1 | x | `Bit` | `a.hpp`, `b.hpp` |": "src/b.hpp declares none"}.items():
        problems = check_row(class_table.row_of(wrong), files.get)
        assert any(words in p for p in problems), (wrong, problems)
    assert not check_row(class_table.row_of("| B.1 | x | none | |"), files.get)


if __name__ == "__main__":
    sources.main(check_all, self_test)
