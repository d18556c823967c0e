"""subtle.py and plain.py: given a line, its mutants."""

import unittest

import lines
import mutants
import plain
import subtle


def made(operator, text):
    """The lines that one operator makes of a line."""
    function = {**subtle.SUBTLE, **plain.PLAIN}[operator]
    code = lines.blanked(text)
    return [text[:a] + new + text[b:] for a, b, new in function(code)]


class Subtle(unittest.TestCase):
    def test_relations_become_their_neighbours(self):
        self.assertEqual(made("relational", "if (a < b && c >= d) x = y == z;"),
                         ["if (a <= b && c >= d) x = y == z;", "if (a < b && c > d) x = y == z;", "if (a < b && c >= d) x = y != z;"])
        self.assertEqual(made("relational", "std::vector<int> v = p->q;"), [])

    def test_the_larger_becomes_the_smaller(self):
        self.assertEqual(made("min max", "a = std::min(b, c.maxCoeff());"), ["a = std::max(b, c.maxCoeff());", "a = std::min(b, c.minCoeff());"])

    def test_a_guard_goes(self):
        self.assertEqual(made("deleted guard", "  if (f(a) > 0) return g(b);"), ["  {}"])
        self.assertEqual(made("deleted guard", "  if (a) continue;"), ["  {}"])
        self.assertEqual(made("deleted guard", "  if (a || b)"), ["  if ((a || b) && false)"])
        self.assertEqual(made("deleted guard", "  if (a) b = c;"), [])

    def test_a_term_or_factor_goes(self):
        self.assertEqual(made("dropped term", "x = a + b * f(c, d - 1);"),
                         ["x = a;", "x = a + b;", "x = a + b * f(c, d);"])
        self.assertEqual(made("dropped term", "if (a && b(c) || d)"), ["if (a || d)", "if (a && b(c))"])
        self.assertEqual(made("dropped term", "x = a + f(b,"), [])

    def test_numbers_and_indices_are_off_by_one(self):
        self.assertEqual(made("off by one", "x = v[i] + w[n - 1];"), ["x = v[i] + w[n];", "x = v[i] + w[n - 2];", "x = v[i - 1] + w[n - 1];"])
        self.assertEqual(made("off by one", "double a = 1.5, e2 = 1e-3;"), [])

    def test_neighbouring_arguments_change_places(self):
        self.assertEqual(made("swapped arguments", "x = f(a, g(b, c), d);"),
                         ["x = f(g(b, c), a, d);", "x = f(a, d, g(b, c));", "x = f(a, g(c, b), d);"])
        self.assertEqual(made("swapped arguments", "if (a < b) f(c, c);"), [])
        self.assertEqual(made("swapped arguments", "x = std::max(a, b);"), [])
        self.assertEqual(made("swapped arguments", "double f(const Vec3& a, double b) {"), [])


class Plain(unittest.TestCase):
    def test_each_changes_what_it_says(self):
        for operator, text, expected in (
                ("arithmetic", "x = a + b / c;", ["x = a - b / c;", "x = a + b * c;"]),
                ("assignment", "a += b;", ["a -= b;"]),
                ("logical", "if (!a && b)", ["if (!a || b)", "if (a && b)"]),
                ("words", "x = true;", ["x = false;"]),
                ("sign", "return -a * f(-b, c - d);", ["return a * f(-b, c - d);", "return -a * f(b, c - d);"]),
                ("twin", "a = std::sin(v.x());", ["a = std::cos(v.x());", "a = std::sin(v.y());"]),
                ("deleted statement", "  list.push_back(a);", ["  {}"]),
                ("deleted statement", "  a.b = c + d;", ["  {}"]),
                ("deleted statement", "  const double a = b(c);", []),
                ("deleted statement", "  return f(a);", [])):
            self.assertEqual(made(operator, text), expected, text)

    def test_a_constant_is_three_tenths_larger_and_a_tolerance_a_thousand_times(self):
        self.assertEqual(made("constant", "x = 0.5 * a + 0.0;"), ["x = 0.65 * a + 0.0;", "x = 0.5 * a + 1.0;"])
        self.assertEqual([float(l.split()[2].rstrip(";")) for l in made("constant", "x = 1e-9;")], [1e-6])


class Mutants(unittest.TestCase):
    def test_no_two_of_a_line_are_the_same_and_none_is_the_line(self):
        text = "if (a < b + 1) f(a, -b);  // a < b"
        found = mutants.of_source("src/a.cpp", text)
        self.assertEqual(len({m.after for m in found}), len(found))
        self.assertNotIn(text, {m.after for m in found})
        self.assertTrue(all(m.after.endswith("// a < b") for m in found))

    def test_a_mutated_source_differs_in_one_line(self):
        text = "a = b;\nc = d + 1;\n"
        mutant = next(m for m in mutants.of_source("src/a.cpp", text) if m.operator == "off by one")
        self.assertEqual(mutants.mutated(text, mutant), "a = b;\nc = d + 2;\n")
        with self.assertRaises(ValueError):
            mutants.mutated("\n" + text, mutant)


if __name__ == "__main__":
    unittest.main()
