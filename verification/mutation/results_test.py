"""results.py, equivalents.py, arguments.py: what is kept, what is judged, what is refused."""

import pathlib
import tempfile
import unittest

import arguments
import equivalents
import results
import rooms

ROW = {"room": "rock", "file": "src/rock/a.cpp", "line": 3, "operator": "relational", "verdict": "failed", "killer": "verify_rock A.b",
       "seconds": 1.5, "before": "a < b", "after": "a <= b"}
ENTRY = '[[equivalent]]\nfile = "src/a.cpp"\nline = "x = a < b;"\nmutation = "{0}"\nreason = "never equal"\n'


class InFolder(unittest.TestCase):
    def setUp(self):
        self.kept = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.kept.name)
        self.addCleanup(self.kept.cleanup)


class Cache(InFolder):
    def test_a_kill_stands_and_a_survivor_is_asked_again_when_tests_changed(self):
        cache = results.Cache(self.folder / "mutants.jsonl")
        cache.add(("hash", "f", 1, "x"), {"verdict": "failed", "tests": "old"})
        cache.add(("hash", "f", 2, "y"), {"verdict": "survived", "tests": "old"})
        again = results.Cache(self.folder / "mutants.jsonl")
        self.assertEqual(again.find(("hash", "f", 1, "x"), "new")["verdict"], "failed")
        self.assertEqual(again.find(("hash", "f", 2, "y"), "old")["verdict"], "survived")
        self.assertIsNone(again.find(("hash", "f", 2, "y"), "new"))
        self.assertIsNone(again.find(("other", "f", 1, "x"), "new"))


class Table(InFolder):
    def test_a_room_replaces_its_rows_and_leaves_the_others(self):
        path = self.folder / "a.csv"
        results.write_table(path, "rock", [ROW, {**ROW, "line": 2}])
        results.write_table(path, "mesh", [{**ROW, "room": "mesh"}])
        results.write_table(path, "rock", [{**ROW, "line": 20}])
        lines = path.read_text(encoding="utf-8").splitlines()
        self.assertEqual([line.split(",")[:3] for line in lines[1:]], [["mesh", "src/rock/a.cpp", "3"], ["rock", "src/rock/a.cpp", "20"]])

    def test_tells_what_killed_a_mutant_before(self):
        path = self.folder / "a.csv"
        self.assertEqual((results.killers(None), results.killers(path)), ({}, {}))
        results.write_table(path, "rock", [ROW, {**ROW, "line": 9, "after": "a > b", "verdict": "survived", "killer": ""}])
        self.assertEqual(results.killers(path), {("src/rock/a.cpp", "a < b", "a <= b"): "verify_rock A.b"})

    def test_the_score_leaves_out_equivalents_and_the_compiler(self):
        rows = [{**ROW, "verdict": v} for v in ("failed", "crashed", "timed out", "survived", "equivalent", "compiler")]
        self.assertIn("3 of 4 killed, 75.0 %", results.score_line("rock", rows))


class Equivalents(InFolder):
    def stale(self, mutation, source):
        (self.folder / "src").mkdir(exist_ok=True)
        (self.folder / "src/a.cpp").write_text(source, encoding="utf-8")
        (self.folder / "list.toml").write_text(ENTRY.format(mutation), encoding="utf-8")
        return equivalents.stale(equivalents.read(self.folder / "list.toml"), self.folder)

    def test_an_entry_must_still_be_a_mutant_of_its_line(self):
        self.assertEqual(self.stale("x = a <= b;", "  x = a < b;\n"), [])
        self.assertIn("no line", self.stale("x = a <= b;", "x = a > b;\n")[0])
        self.assertIn("no operator", self.stale("x = a ~ b;", "x = a < b;\n")[0])

    def test_an_entry_must_say_why(self):
        (self.folder / "list.toml").write_text(ENTRY.format("x = a <= b;").replace("reason", "because"), encoding="utf-8")
        with self.assertRaises(ValueError):
            equivalents.read(self.folder / "list.toml")


class Arguments(unittest.TestCase):
    def test_refuses_what_it_does_not_know(self):
        for words, found in ((["rok"], 'nearest is "rock"'), (["--count", "0"], "found 0, expected a whole number from 1"),
                             (["--seed", "x"], "found x"), (["--sed", "1"], "--sed")):
            with self.assertRaises(arguments.Wrong, msg=words) as wrong:
                arguments.parse(words)
            self.assertIn(found, str(wrong.exception))

    def test_takes_rooms_and_numbers(self):
        chosen = arguments.parse(["rock", "mesh", "--count", "7", "--seed", "3"])
        self.assertEqual((chosen.rooms, chosen.count, chosen.seed), (["rock", "mesh"], 7, 3))

    def test_every_room_of_src_is_known(self):
        self.assertEqual(sorted(rooms.PROGRAMS), sorted(f.name for f in rooms.SRC.iterdir() if f.is_dir()))


if __name__ == "__main__":
    unittest.main()
