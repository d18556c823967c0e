"""Wrong input has the message of the command line in the words of Python, and an exception of its kind."""

import unittest
import warnings

from common import BIT, DRILLING, QUICK, ROOT, TOP, FolderTest, command, words

import numpy as np
import tdbd

CALIBRATION = ROOT / "validation/cases/zijsling-share.toml"


class Mistakes(FolderTest):
    def told(self, *arguments):
        """The message of the command line for wrong input, in the words of Python."""
        done = command(*arguments)
        self.assertEqual(done.returncode, 2, done)
        self.assertTrue(done.stderr.startswith("tdbd: "), done.stderr)
        text = tdbd.errors.in_python_words(done.stderr.removeprefix("tdbd: ").removesuffix("\n"))
        self.assertNotRegex(text, r"(?<![\w-])--[a-z]|tdbd (run|rotate|mesh|bit|check)\b")
        return text

    def test_messages_name_arguments_and_functions(self):
        for told, text in (("--set: rock.edge_lenght: found an unknown key, expected edge_length", "rock.edge_lenght: found an unknown key, expected edge_length"),
                           ("output folder a: exists; --force overwrites", "output folder a: exists; force=True overwrites"),
                           ("--levels: found 1, expected 2 to 60", "levels: found 1, expected 2 to 60"),
                           ("--cone-speeds: found 2 speeds", "cone_speeds: found 2 speeds"),
                           ("a.toml: found a bit, expected a case to drill; try: tdbd bit a.toml", "a.toml: found a bit, expected a case to drill; try: tdbd.bit.read"),
                           ("a.toml: found a drill string, expected a bit; try: tdbd string a.toml", "a.toml: found a drill string, expected a bit"),
                           ("a: found a run of tdbd rotate, expected one of tdbd run; to resume it: tdbd rotate --resume a",
                            "a: found a run of tdbd.rotate, expected one of tdbd.run; to resume it: tdbd.resume"),
                           ("a.stl: to repair: tdbd mesh 'a.stl' --repair -o 'b.stl'", "a.stl: tdbd.mesh.repair may repair it"),
                           ("a.stl: points nearly meet; try --weld 0.01 mm", "a.stl: points nearly meet; try weld=0.01 mm"),
                           ("written by tdbd 3.1, use another folder -- or none", "written by tdbd 3.1, use another folder -- or none")):
            self.assertEqual(tdbd.errors.in_python_words(told), text)

    def test_mistakes_have_found_and_expected(self):
        mistake = tdbd.errors._mistake("a b.toml:7: rock.edge_length: found 1 kg, expected a length in m, > 0")
        self.assertEqual(mistake[:3], ("a b.toml", 7, "rock.edge_length"))
        self.assertEqual((mistake.found, mistake.expected), ("1 kg", "a length in m, > 0"))
        mistake = tdbd.errors._mistake("a.toml: found a bit, with a table [cutters], expected a case to drill; try: tdbd.bit.read")
        self.assertEqual((mistake.file, mistake.key, mistake.found), ("a.toml", "", "a bit, with a table [cutters]"))
        self.assertEqual(mistake.expected, "a case to drill")
        self.assertEqual(tdbd.errors._mistake("something else")[:], ("", 0, "", "something else"))
        self.assertEqual(tdbd.errors._mistake("something else").found, "")

    def test_overrides(self):
        for settings in ({"rock.edge_lenght": "2 mm"}, {"rock.edge_length": "2 kg"}, {"rock.edge_length": -1}, {"rock.edge_length": True},
                         {"rock.edge_length": [1, 2]}, {"time.revolutions": 0, "rock.wall": "x"}, {"no.such.table": 1},
                         {"motion": 3}, {"a..b": 1}, {"rock.edge_length": "1 mm\n[b]"}):
            with self.subTest(settings):
                text = {k: str(v).lower() if isinstance(v, bool) else v for k, v in settings.items()}
                with self.assertRaises(tdbd.CaseError) as raised:
                    tdbd.case(DRILLING, set=settings)
                self.assertEqual(str(raised.exception), self.told("check", DRILLING, *words(text)))
                self.assertIsInstance(raised.exception, ValueError)

    def test_the_nearest_name(self):
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.case(DRILLING, rock__edge_lenght="2 mm")
        error = raised.exception
        self.assertEqual((error.file, error.line, error.key), ("", 0, "rock.edge_lenght"))
        self.assertEqual((error.found, error.expected), ("an unknown key", "edge_length"))
        self.assertEqual(error.mistakes[0].text, "found an unknown key, expected edge_length")

    def test_a_file_with_two_mistakes(self):
        case = self.folder / "a case: of mine.toml"
        case.write_text(DRILLING.read_text().replace('"bits/', f'"{ROOT}/cases/bits/').replace("1.0 mm", "1.0 kg") + "stepp = 1\n")
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.case(case)
        lines = case.read_text().split("\n")
        place = lambda start: next(i for i, line in enumerate(lines, 1) if line.startswith(start))
        self.assertEqual([(m.file, m.line, m.key) for m in raised.exception.mistakes],
                         [(str(case), place("edge_length"), "rock.edge_length"), (str(case), place("stepp"), "time.stepp")])
        self.assertEqual(str(raised.exception), self.told("check", case))

    def test_files(self):
        (self.folder / "no.toml").write_text("a = = 1\n")
        (self.folder / "empty.toml").write_text("")
        for file in ("nothing.toml", "no.toml", "empty.toml", "."):
            with self.subTest(file), self.assertRaises(tdbd.CaseError) as raised:
                tdbd.case(self.folder / file)
            self.assertEqual(str(raised.exception), self.told("run", self.folder / file, "-o", self.folder / "never"), file)
        self.assertRaisesRegex(ValueError, "zero byte", tdbd.case, f"{DRILLING}\0")
        self.assertEqual(tdbd.case(bytes(DRILLING)).path, str(DRILLING))
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.case(self.folder / "no.toml")
        self.assertEqual((raised.exception.file, raised.exception.line), (str(self.folder / "no.toml"), 1))

    def test_kinds(self):
        for call, name, file in ((tdbd.run, "run", TOP), (tdbd.rotate, "rotate", DRILLING), (tdbd.calibrate, "calibrate", TOP),
                                 (tdbd.run, "run", CALIBRATION), (tdbd.check, "check", CALIBRATION)):
            with self.subTest(name), self.assertRaises(tdbd.CaseError) as raised:
                call(tdbd.case(file))
            # `tdbd check` reads strings, too.
            self.assertEqual(str(raised.exception), self.told(name, file).replace(" or a drill string", ""), name)
        for kind in (tdbd.Simulation, tdbd.run):
            with self.assertRaisesRegex(tdbd.CaseError, "found a body to rotate, .*expected a case to drill; try: tdbd.rotate"):
                kind(TOP)
        with self.assertRaisesRegex(tdbd.CaseError, "found a bit, with a table .*try: tdbd.bit.read"):
            tdbd.case(BIT)

    def test_studies(self):
        for levels, factor, over, text in ((1, 2, "time.step", "^levels: found 1, expected 2 to 60"), (61, 2, "time.step", "^levels: found 61"),
                                           (3, 1, "time.step", "^factor: found 1, expected a number > 1"),
                                           (3, 2, [], "^over: found none"), (3, 2, "time.stepp", "^over: found time.stepp, expected a quantity")):
            with self.subTest(text), self.assertRaisesRegex(tdbd.CaseError, text):
                tdbd.converge(TOP, over, levels, factor, folder=self.folder / "a")
        self.assertFalse((self.folder / "a").exists())
        told = self.told("converge", TOP, "--over", "time.stepp", "--levels", 3, "-o", self.folder / "a")
        with self.assertRaises(tdbd.CaseError) as raised:
            tdbd.converge(TOP, "time.stepp", 3)
        self.assertEqual(str(raised.exception), told)

    def test_types(self):
        for value in (None, {"a": 1}, b"2 mm", object()):
            with self.subTest(value), self.assertRaisesRegex(TypeError, "rock.edge_length: found .*, expected a text"):
                tdbd.case(DRILLING, rock__edge_length=value)
        with self.assertRaisesRegex(TypeError, "set: found str, expected a dictionary"):
            tdbd.case(DRILLING, "rock.edge_length=2 mm")
        with self.assertRaises(TypeError):
            tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "a", 5)
        with self.assertRaisesRegex(TypeError, "progress: found int, expected a function of done and total"):
            tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "a", progress=5)
        self.assertFalse((self.folder / "a").exists())

    def test_values(self):
        legs = [{"duration": 1}]
        self.assertRaises(TypeError, tdbd.case, DRILLING, motion__legs=legs)
        for value, text in ((np.float64(0.002), "0.002"), (np.int64(3), "3"), (2e-3, "0.002"), ("2 mm", "2 mm"), (np.bool_(True), "true"),
                            (["a\"b", 1.5, [True]], '["a\\"b", 1.5, [true]]'), (np.array([1.0, 2.0]), "[1.0, 2.0]"), (DRILLING, str(DRILLING))):
            self.assertEqual(tdbd.arguments.assignments({}, {"a__b": value}), [f"a.b={text}"])
        self.assertEqual(tdbd.case(DRILLING, set={"rock.edge_length": 1}, rock__edge_length="2 mm").quantities["rock.edge_length"], 2e-3)

    def test_folders(self):
        case = tdbd.case(DRILLING, set=QUICK)
        tdbd.run(case, self.folder / "full")
        (self.folder / "file").write_text("mine")
        (self.folder / "mine").mkdir()
        (self.folder / "mine/summary.json").write_text("{}")
        for folder, force in (("full", False), ("file", False), ("mine", True)):
            with self.subTest(folder), self.assertRaises(FileExistsError) as raised:
                tdbd.run(case, self.folder / folder, force=force)
            self.assertIsInstance(raised.exception, tdbd.FolderError)
            told = self.told("run", DRILLING, *words(QUICK), "-o", self.folder / folder, *(["--force"] if force else []))
            self.assertEqual(str(raised.exception), told)
            self.assertEqual(raised.exception.folder, str(self.folder / folder))
            self.assertTrue(raised.exception.reason)
        self.assertEqual((self.folder / "mine/summary.json").read_text(), "{}")
        self.assertEqual(tdbd.run(case, self.folder / "full", force=True).summary["status"], "completed")

    def test_numbers(self):
        case = tdbd.case(DRILLING, set=QUICK)
        sim = tdbd.Simulation(case)
        with self.assertRaisesRegex(ValueError, "steps: found -1, expected 0 or more"):
            sim.step(-1)
        with self.assertRaises(TypeError):
            sim.step(1.5)
        for threads in (0, -3, 1025):
            with self.assertRaisesRegex(ValueError, f"threads: found {threads}, expected 1 to 1024"):
                tdbd.run(case, self.folder / "a", threads=threads)
        self.assertFalse((self.folder / "a").exists())

    def test_a_failing_computation(self):
        case = tdbd.case(TOP, set={"time.step": "10 s", "time.duration": "20 s", "integrator.drift": "lie-midpoint"})
        with self.assertRaises(tdbd.RunError) as raised:
            tdbd.rotate(case, self.folder / "failed")
        self.assertEqual((self.folder / "failed/failure.txt").read_text(), f"{raised.exception}\n")
        self.assertIsInstance(raised.exception, RuntimeError)

    def test_warnings(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            tdbd.case(ROOT / "cases/drill-bit-b.toml", forces__A7=1.0)
        self.assertEqual([w.category for w in told], [tdbd.CaseWarning])
        self.assertIn("A7", str(told[0].message))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
