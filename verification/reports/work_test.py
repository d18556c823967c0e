#!/usr/bin/python3
"""Actions on all processors: every one is done, complaints keep their order, anything else is an error."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "reports"))
from fingerprint import Stale  # noqa: E402
from work import gather, gather_at_once  # noqa: E402


class Work(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def leave(self, number):
        (self.folder / str(number)).write_text(str(os.getpid()), encoding="utf-8")
        if number % 3 == 0:
            raise Stale(f"{number} is stale")

    def test_does_all_and_keeps_the_order_of_complaints(self):
        numbers = range(20)
        for gathered in (gather, gather_at_once, lambda a: gather_at_once(a, processes=5)):
            found = gathered([(self.leave, n) for n in numbers])
            self.assertEqual(found, [f"{n} is stale" for n in numbers if n % 3 == 0])
            self.assertEqual({int(f.name) for f in self.folder.iterdir()}, set(numbers))

    def test_lets_errors_through(self):
        def fail(_):
            raise ZeroDivisionError
        for gathered in (gather, gather_at_once):
            with self.assertRaises(ZeroDivisionError):
                gathered([(fail, 1), (fail, 2)])


if __name__ == "__main__":
    unittest.main()
