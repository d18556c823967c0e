"""Suites of tests are in CamelCase, the names of tests are sentences in snake_case.

In a test's name a single capital may stand for a quantity: a_wheel_rolls_at_R_over_rho.
"""

import re

import sources

TEST = re.compile(r"^\s*(?:TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+)\s*,\s*(\w+)", re.MULTILINE)
SUITE = re.compile(r"([A-Z][a-z0-9]*)+")
WORD = r"(?:[a-z0-9]+|[A-Z])"
NAME = re.compile(rf"{WORD}(_{WORD})*")


def check_text(path, text):
    problems = []
    code = sources.without_comments(text)
    for match in TEST.finditer(code):
        suite, name = match.groups()
        where = f"{path}:{code.count(chr(10), 0, match.start(1)) + 1}"
        if not SUITE.fullmatch(suite):
            problems.append(f"{where}: the suite {suite} is not in CamelCase")
        if not NAME.fullmatch(name):
            problems.append(f"{where}: the test {name} is not in snake_case")
    return problems


def check_all():
    files = sources.tracked("verification", "benchmarks", "examples", suffixes=(".cpp", ".hpp"))
    return [p for f in files for p in check_text(f, sources.read(f))]


def self_test():
    good = ["TEST(SweptConvex, moves_no_vertex)", "TEST_F(So3, exp_of_0)", "RC_GTEST_PROP(NearList,\n    is_whole, ())",
            "TEST(Cone, a_wheel_rolls_at_R_over_rho)", "// TEST(old, Name)", 'f("TEST(old, x)");', "TYPED_TEST(A, b)"]
    bad = ["TEST(swept_convex, moves)", "TEST(SweptConvex, MovesNoVertex)", "TEST_P(Swept_Convex, moves)",
           "RC_GTEST_PROP(nearList,\n    is_whole, ())", "TEST(A, two__words)", "TEST(A, ends_)"]
    for text in good:
        assert not check_text("a.cpp", text), text
    for text in bad:
        assert len(check_text("a.cpp", "\n" + text)) == 1 and ":2:" in check_text("a.cpp", "\n" + text)[0], text


if __name__ == "__main__":
    sources.main(check_all, self_test)
