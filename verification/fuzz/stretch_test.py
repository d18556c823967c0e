"""stretch_test.py: pieces of an input repeat in their place, up to a MiB; numbered copies all differ."""

import pathlib
import sys
import tempfile
import unittest

import stretch

TEXT = b"time,speed\n0.5,1\n1.5,2\nend\n"


class Stretch(unittest.TestCase):
    def test_repeats_a_piece_in_its_place(self):
        long = stretch.stretched(TEXT, 11, 17)
        self.assertTrue(long.startswith(TEXT[:17]))
        self.assertTrue(long.endswith(TEXT[17:]))
        self.assertEqual(long.count(b"0.5,1\n"), (len(long) - len(TEXT)) // 6 + 1)
        self.assertTrue(stretch.SIZE - 2 * 6 < len(long) <= stretch.SIZE)

    def test_numbers_copies_so_that_no_two_are_equal(self):
        lines = stretch.numbered(TEXT, 11, 17).splitlines()[2:-2]
        self.assertGreater(len(lines), 10_000)
        self.assertEqual(len(set(lines)), len(lines))

    def test_takes_a_line_of_each_kind_and_its_words(self):
        spans = stretch.pieces(TEXT)
        self.assertIn((11, 17), spans)
        self.assertNotIn((17, 23), spans)  # of the same kind
        self.assertIn((0, 5), spans)

    def test_writes_one_file_for_each_piece(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "table.csv"
            file.write_bytes(TEXT)
            sys.argv = ["stretch.py", str(file), folder + "/long"]
            stretch.main()
            sizes = [f.stat().st_size for f in (pathlib.Path(folder) / "long").iterdir()]
        self.assertGreaterEqual(len(sizes), len(stretch.pieces(TEXT)))
        self.assertLessEqual(max(sizes), stretch.SIZE)


if __name__ == "__main__":
    unittest.main()
