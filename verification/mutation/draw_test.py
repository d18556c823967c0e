"""mutants.drawn: half of the sample is subtle, no mutant comes twice, and a changed file leaves the other files' order alone."""

import itertools
import unittest

import mutants

SOURCE = "\n".join(f"if (a{i} < b{i} + {i % 7}.5) f(c{i}, -d{i});" for i in range(40))


def all_of(**texts):
    return [m for name, text in sorted(texts.items()) for m in mutants.of_source(name, text)]


class Draw(unittest.TestCase):
    def test_takes_subtle_and_plain_in_turn(self):
        sample = list(itertools.islice(mutants.drawn(all_of(a=SOURCE), 1), 40))
        self.assertEqual([m.is_subtle for m in sample], [True, False] * 20)

    def test_takes_all_each_once(self):
        everything = all_of(a=SOURCE)
        sample = list(mutants.drawn(everything, 1))
        self.assertEqual(len(sample), len(set(sample)))
        self.assertEqual(set(sample), set(everything))

    def test_takes_other_lines_before_a_second_of_one(self):
        subtle = [m for m in mutants.drawn(all_of(a=SOURCE), 1) if m.is_subtle][:40]
        self.assertEqual(len({m.line for m in subtle}), 40)

    def test_follows_the_seed(self):
        first = [list(itertools.islice(mutants.drawn(all_of(a=SOURCE), seed), 20)) for seed in (1, 1, 2)]
        self.assertEqual(first[0], first[1])
        self.assertNotEqual(first[0], first[2])

    def test_a_changed_file_leaves_the_order_of_the_others(self):
        before = [m for m in mutants.drawn(all_of(a=SOURCE, b="x = y + 1;"), 1) if m.file == "a"]
        after = [m for m in mutants.drawn(all_of(a=SOURCE, b="x = y - z;\ng(x, y);"), 1) if m.file == "a"]
        self.assertEqual([m for m in before if m.is_subtle], [m for m in after if m.is_subtle])
        self.assertEqual([m for m in before if not m.is_subtle], [m for m in after if not m.is_subtle])


if __name__ == "__main__":
    unittest.main()
