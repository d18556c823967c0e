"""Algorithms of std::ranges that the page for browsers compiles are in web/libcxx13.hpp.

The library of emscripten has none of them. scripts/web is not part of the tests, because few machines have
emscripten; this rule finds a new algorithm without it.
"""

import re

import sources

SHIM = "web/libcxx13.hpp"
# What web/CMakeLists.txt links: tdbd_simulation and what that needs.
COMPILED = ("src/core/", "src/io/", "src/mesh/", "src/bit/", "src/forces/", "src/rotation/", "src/string/", "src/dynamics/", "src/rock/",
            "src/simulation/", "web/")
USED = re.compile(r"\bstd::ranges::(\w+)\s*[({]")
DEFINED = re.compile(r"^(?:inline |constexpr )*\w+ (\w+)\(", re.MULTILINE)
IN_LIBRARY = {"less", "greater", "equal_to", "begin", "end", "size"}  # of emscripten


def check_text(path, text, known):
    problems = []
    for number, line in enumerate(sources.without_comments(text).split("\n"), 1):
        problems += [f"{path}:{number}: found std::ranges::{name}, which {SHIM} lacks: add it there"
                     for name in USED.findall(line) if name not in known]
    return problems


def check_all():
    known = IN_LIBRARY | set(DEFINED.findall(sources.read(SHIM)))
    return [p for folder in ("src", "web") for f in sources.tracked(folder) if f.startswith(COMPILED) and f != SHIM
            for p in check_text(f, sources.read(f), known)]


def self_test():
    known = IN_LIBRARY | set(DEFINED.findall("bool any_of(R&& r, Test test) {\n  return inner_call(r);\n}\nauto find(R&& r) {}\n"))
    assert "any_of" in known and "find" in known and "inner_call" not in known, known
    assert check_text("src/bit/a.cpp", "std::ranges::nth_element(all, all.begin());", known)
    assert not check_text("src/bit/a.cpp", "f(std::ranges::any_of(all, test), std::ranges::less{});  // std::ranges::sort(x)", known)


if __name__ == "__main__":
    sources.main(check_all, self_test)
