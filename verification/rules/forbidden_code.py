"""Words that make results depend on the machine or the run do not occur in src."""

import re

import sources

FORBIDDEN = {
    r"\bs?rand\s*\(|\brand_r\b|\bdrand48\b": "rand(): use core/random.hpp",
    r"\brandom_device\b": "std::random_device: every run starts from a written seed",
    r"\bstd::\w+_distribution\b": "distributions differ between libraries: use core/random.hpp",
    r"\bfloat\b": "float: the program computes in double (to turn vertices away: core/simd.hpp)",
    r"\bunordered_\w+": "unordered containers: their order differs between libraries",
}

# The one place that may name what it wraps.
ALLOWED = {"src/core/simd.hpp": r"\bfloat\b"}


def check_text(path, text):
    problems = []
    for number, line in enumerate(sources.without_comments(text).split("\n"), 1):
        for pattern, why in FORBIDDEN.items():
            if pattern != ALLOWED.get(path) and re.search(pattern, line):
                problems.append(f"{path}:{number}: {why}")
    return problems


def check_all():
    return [p for f in sources.tracked("src") for p in check_text(f, sources.read(f))]


def self_test():
    bad = ["int i = rand();", "srand(1);", "std::random_device d;", "float x;", "std::vector<float> v;",
           "#include <unordered_map>", "std::unordered_set<int> s;",
           "std::normal_distribution<double> n;"]
    good = ["double x;  // not a float", 'f("float");', "int operand(1);", "double floating = 1;",
            "/* rand() */ int a;"]
    for text in bad:
        assert check_text("src/a.cpp", text), text
    for text in good:
        assert not check_text("src/a.cpp", text), text
    assert not check_text("src/core/simd.hpp", "using Single = float;")
    assert check_text("src/core/simd.hpp", "int i = rand();")


if __name__ == "__main__":
    sources.main(check_all, self_test)
