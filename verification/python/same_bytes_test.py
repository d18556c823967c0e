"""The package leaves the files of the command line: all bytes but those of timing.json."""

import unittest

from common import CONES, DRILLING, DRIVEN, QUICK, TOP, FolderTest, command, words

import tdbd

RUNS = {
    "steady": (DRILLING, QUICK | {"output.frames_every": 5, "output.history_every": 3}),
    "driven": (DRIVEN, {"rock.edge_length": "6 mm", "time.duration": "0.05 s"}),
    "cones": (CONES, {"rock.edge_length": "8 mm", "time.step": "5 ms", "time.revolutions": 0.5}),
}


class SameBytes(FolderTest):
    def setUp(self):
        super().setUp()
        self.demand_one_commit()

    def test_run(self):
        for name, (case, settings) in RUNS.items():
            with self.subTest(name):
                done = command("run", case, *words(settings), "-o", self.folder / name / "a", "--quiet")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(all(line.startswith("tdbd: warning: ") for line in done.stderr.splitlines()), done.stderr)
                result = tdbd.run(tdbd.case(case, set=settings), self.folder / name / "b")
                files = self.same_files(self.folder / name / "a", result.folder)
                self.assertLessEqual({"summary.json", "history.nc", "history.csv", "case.toml", "rock_final.ply"}, set(files))

    def test_run_on_two_threads(self):
        one = tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "one")
        two = tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "two", threads=2)
        self.same_files(one.folder, two.folder)

    def test_rotate(self):
        done = command("rotate", TOP, *words({"time.duration": "1 s"}), "-o", self.folder / "a", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        result = tdbd.rotate(tdbd.case(TOP, time__duration=1), self.folder / "b")
        self.assertIn("history.nc", self.same_files(self.folder / "a", result.folder))

    def test_converge(self):
        study = ("--over", "time.step", "--levels", 4)
        done = command("converge", TOP, *words({"time.duration": "1 s"}), *study, "-o", self.folder / "a")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = tdbd.converge(tdbd.case(TOP, time__duration="1 s"), "time.step", 4, folder=self.folder / "b")
        self.same_files(self.folder / "a", self.folder / "b")
        self.assertTrue(done.stdout.startswith(found.table), done.stdout)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
