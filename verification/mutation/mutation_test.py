"""mutation_test.py: which mutants a source has, their draw, the run of their tests, and the list of equivalent ones."""

import itertools
import os
import pathlib
import subprocess
import tempfile
import unittest

import arguments
import build
import equivalents
import lines
import mutants
import plain
import results
import scopes
import subtle
import watch

# Prints what a GoogleTest program prints for tests that are named after what they do.
PROGRAM = """#!/bin/bash
for word in "$@"; do case $word in --gtest_filter=*) names=${word#*=} ;; esac; done
IFS=:
count=0
for name in $names; do
  [ "$name" = A.none ] && continue
  count=$((count + 1))
  echo "[ RUN      ] $name"
  case $name in
    A.fails) echo "[  FAILED  ] $name (1 ms)"; echo "[==========] $count tests from 1 test suite ran."; exit 1 ;;
    A.crashes) kill -SEGV $$ ;;
    A.hangs) bash -c 'while :; do :; done' ;;
    A.exits) exit 0 ;;
  esac
done
echo "[==========] $count tests from 1 test suite ran. (1 ms total)"
"""
SCOPES = """namespace tdbd::bit {
namespace {
constexpr int most = 3;
struct Room {
  int size{f({1})};
  bool operator<(const Room& r) const { return size < r.size; }
};
template <class F>
void each(
    F f) {
  for (int i : {1, 2}) f(i);
}
}  // namespace
Room::Room(int n)
    : size(n) {
  if (n > 3) grow();
}
}  // namespace tdbd::bit
"""
SOURCE = "\n".join(f"if (a{i} < b{i} + {i % 7}.5) f(c{i}, -d{i});" for i in range(40))


def made(operator, text):
    """The lines that one operator makes of a line."""
    code = lines.blanked(text)
    return [text[:a] + new + text[b:] for a, b, new in {**subtle.SUBTLE, **plain.PLAIN}[operator](code)]


class Lines(unittest.TestCase):
    def offered(self, text):
        return [line.text.strip() for line in lines.mutable(text)]

    def test_blanks_comments_and_strings_column_for_column(self):
        text = 'f("a // b", \'"\');  // min\ng(10\'000);\n/* x\ny */ int i = 1;'
        code = lines.blanked(text)
        self.assertEqual([len(l) for l in code.split("\n")], [len(l) for l in text.split("\n")])
        self.assertEqual(code.split("\n")[0].rstrip(), 'f("~~~~~~", \'~\');')
        self.assertEqual(code.split("\n")[1:], ["g(10'000);", "    ", "     int i = 1;"])

    def test_offers_statements_but_no_comment_include_hint_table_or_message(self):
        for text in ("a = b + 1;", "if (a < b) return;", "for (int i = 0; i < n; ++i) {", 'word == "bit";'):
            self.assertEqual(self.offered(text), [text])
        for text in ("// a = b + 1;", '#include "a/b.hpp"', "static_assert(a < b);", "list.reserve(n + 1);", "{1.0, 2.0, -3e-4},",
                     'f("found " + number + 1);', 'throw InputError("x" + n);', "", "}"):
            self.assertEqual(self.offered(text), [], text)
        self.assertEqual(self.offered('if (i > 0)\n  return fmt::format("entry {}",\n                     i + 1);\na = b;'), ["if (i > 0)", "a = b;"])


class Operators(unittest.TestCase):
    def test_change_what_their_names_say(self):
        for operator, text, expected in (
                ("relational", "if (a < b && c >= d)", ["if (a <= b && c >= d)", "if (a < b && c > d)"]),
                ("min max", "a = std::min(b, c);", ["a = std::max(b, c);"]),
                ("deleted guard", "  if (f(a) > 0) return g(b);", ["  {}"]), ("deleted guard", "  if (a || b)", ["  if ((a || b) && false)"]),
                ("dropped term", "x = a + b * f(c);", ["x = a;", "x = a + b;"]), ("dropped term", "x = a + f(b,", []),
                ("off by one", "x = v[i] + w[n - 1];", ["x = v[i] + w[n];", "x = v[i] + w[n - 2];", "x = v[i - 1] + w[n - 1];"]),
                ("swapped arguments", "x = f(a, g(b), d);", ["x = f(g(b), a, d);", "x = f(a, d, g(b));"]),
                ("arithmetic", "x = a + b / c;", ["x = a - b / c;", "x = a + b * c;"]), ("assignment", "a += b;", ["a -= b;"]),
                ("logical", "if (!a && b)", ["if (!a || b)", "if (a && b)"]), ("words", "x = true;", ["x = false;"]),
                ("sign", "return -a * f(-b, c - d);", ["return a * f(-b, c - d);", "return -a * f(b, c - d);"]),
                ("twin", "a = std::sin(v.x());", ["a = std::cos(v.x());", "a = std::sin(v.y());"]),
                ("constant", "x = 0.5 * a + 0.0;", ["x = 0.65 * a + 0.0;", "x = 0.5 * a + 1.0;"]),
                ("deleted statement", "  a.b = c + d;", ["  {}"]), ("deleted statement", "  const double a = b(c);", [])):
            self.assertEqual(made(operator, text), expected, (operator, text))


class Draw(unittest.TestCase):
    def test_is_the_same_for_a_function_in_another_file_and_another_one_for_another_seed(self):
        drawn = lambda file, seed: list(itertools.islice(mutants.drawn(mutants.of_source(file, SOURCE), seed), 40))
        first, moved, other = drawn("a", 1), drawn("b", 1), drawn("a", 2)
        self.assertEqual([(m.line, m.after) for m in first], [(m.line, m.after) for m in moved])
        self.assertNotEqual(first, other)
        self.assertEqual([m.is_subtle for m in first], [True, False] * 20)
        self.assertEqual(len({m.line for m in first if m.is_subtle}), 20)

    def test_a_mutated_source_differs_in_one_line(self):
        text = "a = b;\nc = d + 1;\n"
        mutant = next(m for m in mutants.of_source("src/a.cpp", text) if m.operator == "off by one")
        self.assertEqual(mutants.mutated(text, mutant), "a = b;\nc = d + 2;\n")
        with self.assertRaises(ValueError):
            mutants.mutated("\n" + text, mutant)


class Run(unittest.TestCase):
    def outcome(self, *names):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text(PROGRAM, encoding="utf-8")
            os.chmod(program, 0o700)
            return watch.run_tests(program, names, lambda test: 0.3, {}, folder)

    def test_reports_how_a_program_ends(self):
        self.assertEqual(self.outcome("A.a", "A.b"), watch.Outcome("passed", "", 2))
        self.assertEqual(self.outcome("A.a", "A.fails", "A.b"), watch.Outcome("failed", "A.fails", 2))
        self.assertEqual(self.outcome("A.a", "A.crashes"), watch.Outcome("crashed", "A.crashes", 2))
        self.assertEqual(self.outcome("A.a", "A.hangs"), watch.Outcome("timed out", "A.hangs", 2))
        self.assertEqual(self.outcome("A.exits").verdict, "crashed")
        with self.assertRaises(ValueError):
            self.outcome("A.none")

    def test_the_mutant_takes_precedence_over_the_object_in_the_library(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("main", "int f(); int g(); int main() { return 10 * f() + g(); }"), ("both", "int f() { return 1; } int g() { return 3; }"),
                               ("mutant", "int f() { return 2; }")):
                (pathlib.Path(folder) / f"{name}.cpp").write_text(text, encoding="utf-8")
                subprocess.run(["c++", "-c", f"{name}.cpp"], cwd=folder, check=True)
            subprocess.run(["ar", "rc", "lib.a", "both.o"], cwd=folder, check=True)
            words = build.with_object(["c++", "main.o", "-o", "program", "lib.a"], "both.o", "mutant.o")
            subprocess.run([*words, build.FIRST_COUNTS], cwd=folder, check=True)
            self.assertEqual(subprocess.run([f"{folder}/program"], check=False).returncode, 23)


class Verdicts(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_a_survivor_is_judged_again_when_tests_changed(self):
        cache = results.Cache(self.folder / "mutants.jsonl")
        cache.add(("hash", "f", 1, "x"), {"verdict": "failed", "tests": "old"})
        cache.add(("hash", "f", 2, "y"), {"verdict": "survived", "tests": "old"})
        again = results.Cache(self.folder / "mutants.jsonl")
        self.assertEqual(again.find(("hash", "f", 1, "x"), "new")["verdict"], "failed")
        self.assertEqual(again.find(("hash", "f", 2, "y"), "old")["verdict"], "survived")
        self.assertIsNone(again.find(("hash", "f", 2, "y"), "new"))

    def test_the_score_leaves_out_equivalents_and_the_compiler(self):
        rows = [{"verdict": v} for v in ("failed", "crashed", "timed out", "survived", "equivalent", "compiler")]
        self.assertIn("3 of 4 killed, 75.0 %", results.score_line("rock", rows))

    def test_lines_are_named_by_their_function(self):
        names = dict(zip(SCOPES.split("\n"), scopes.of_lines(SCOPES)))
        for line, name in (("constexpr int most = 3;", "bit"), ("  int size{f({1})};", "bit::Room"), ("    F f) {", "bit::each"),
                           ("  bool operator<(const Room& r) const { return size < r.size; }", "bit::Room::operator<"),
                           ("  for (int i : {1, 2}) f(i);", "bit::each"), ("  if (n > 3) grow();", "bit::Room::Room")):
            self.assertEqual(names[line], name, line)

    def test_an_equivalent_is_found_by_function_and_text(self):
        (self.folder / "src/bit").mkdir(parents=True)
        (self.folder / "src/bit/merged.cpp").write_text(SCOPES, encoding="utf-8")
        judged = lambda *entry: equivalents.stale({entry: "reason"}, self.folder)
        self.assertEqual(judged("bit::Room::Room", "if (n > 3) grow();", "if (n >= 3) grow();"), [])
        self.assertIn("the line is in bit::Room::Room", judged("bit::Room", "if (n > 3) grow();", "if (n >= 3) grow();")[0])
        self.assertIn("no operator", judged("bit::Room::Room", "if (n > 3) grow();", "if (n ~ 3) grow();")[0])
        self.assertIn("no such line", judged("bit::Room::Room", "if (n > 4) grow();", "if (n >= 4) grow();")[0])
        self.assertIn("no such function", judged("bit::module", "if (n > 4) grow();", "if (n >= 4) grow();")[0])
        self.assertTrue(equivalents.read())

    def test_the_command_line_rejects_what_it_does_not_know(self):
        for words, found in ((["rok"], 'nearest is "rock"'), (["--count", "0"], "found 0, expected a whole number from 1"), (["--sed", "1"], "--sed")):
            with self.assertRaises(arguments.Wrong) as wrong:
                arguments.parse(words)
            self.assertIn(found, str(wrong.exception))


if __name__ == "__main__":
    unittest.main()
