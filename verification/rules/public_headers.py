"""src/public_headers.txt lists headers that exist, by module in the order of include_rules.py.

The README of a module that has an example includes public headers only, and names the first one.
"""

import re

import include_rules
import sources

LIST = "src/public_headers.txt"
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
MODULES = [module for module in include_rules.ALLOWED if module != "app"]


def headers_of(text):
    """The listed headers, in order."""
    lines = [line.strip() for line in text.split("\n")]
    return [line for line in lines if line and not line.startswith("#")]


def check_list(headers, existing):
    """Problems of the list itself. `existing`: paths below src."""
    problems = [f"{LIST}: {header} does not exist" for header in headers if header not in existing]
    problems += [f"{LIST}: {header} occurs twice" for header in sorted(set(headers)) if headers.count(header) > 1]
    listed = list(dict.fromkeys(header.split("/")[0] for header in headers))
    if sorted(listed) != sorted(MODULES):
        problems.append(f"{LIST}: found headers of {', '.join(listed)}; expected of {', '.join(MODULES)}")
    return problems


def check_readme(module, text, headers):
    """Problems of the README of a module."""
    path, first = f"src/{module}/README.md", next((h for h in headers if h.startswith(module + "/")), "")
    problems = [f"{path}: the example includes {header}, which is not in {LIST}"
                for header in INCLUDE.findall(text) if header not in headers]
    stem = first.removeprefix(module + "/").removesuffix(".hpp")
    if first and stem not in text and stem.split("/")[-1] not in text:
        problems.append(f"{path}: does not name {first}, the header to start with")
    return problems


def check_all():
    headers = headers_of(sources.read(LIST))
    existing = [path.removeprefix("src/") for path in sources.tracked("src", suffixes=(".hpp",))]
    problems = check_list(headers, existing)
    for module in MODULES:
        problems += check_readme(module, sources.read(f"src/{module}/README.md"), headers)
    return problems


def self_test():
    all_of_them = [f"{module}/a.hpp" for module in MODULES]
    assert not check_list(all_of_them, all_of_them)
    assert len(check_list(all_of_them, all_of_them[1:])) == 1
    assert len(check_list(all_of_them + all_of_them[:1], all_of_them)) == 1
    assert len(check_list(all_of_them[1:], all_of_them)) == 1
    assert not check_readme("rock", '#include "rock/a.hpp"\n', ["rock/a.hpp"])
    assert len(check_readme("rock", '#include "rock/b.hpp"\n`a`', ["rock/a.hpp"])) == 1
    assert len(check_readme("rock", "nothing", ["rock/start.hpp"])) == 1


if __name__ == "__main__":
    sources.main(check_all, self_test)
