"""layouts_test.py TDBD ROOT: other layouts change the keys that they list, and give bits that can be built."""

import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

TDBD, ROOT = map(pathlib.Path, sys.argv[1:])
sys.path.insert(0, str(ROOT / "validation"))
import comparison  # noqa: E402
import layouts  # noqa: E402

LAYOUTS = tomllib.loads((ROOT / "validation/layouts.toml").read_text(encoding="utf-8"))["layout"]
TEXT = """name = "x"
[design.overlap]
axis = 0.4                # comment
[design.back_rake]
axis = "15 deg"
"""


class Changed(unittest.TestCase):
    def test_only_the_named_key_of_the_named_table(self):
        found = tomllib.loads(layouts.changed(TEXT, {"design.back_rake.axis": "20 deg"}))
        self.assertEqual(found["design"], {"overlap": {"axis": 0.4}, "back_rake": {"axis": "20 deg"}})

    def test_refuses_a_key_that_is_not_there(self):
        with self.assertRaisesRegex(comparison.Problem, "design.back_rake.nose"):
            layouts.changed(TEXT, {"design.back_rake.nose": "20 deg"})

    def test_longer_starts_of_a_name_win(self):
        layout = {"keys": {"nov5": {"a": 2}, "": {"a": 1, "b": 3}}}
        self.assertEqual(layouts.keys_of(layout, "nov5"), {"a": 2, "b": 3})
        self.assertEqual(layouts.keys_of(layout, "nov4"), {"a": 1, "b": 3})


class Layouts(unittest.TestCase):
    def test_are_bits_that_can_be_built_and_differ_from_ours(self):
        with tempfile.TemporaryDirectory() as name:
            for k, layout in enumerate(LAYOUTS):
                folder = pathlib.Path(name) / str(k)
                layouts.write_bits(folder, layout)
                differ = 0
                for file in sorted(folder.glob("*.toml")):
                    with self.subTest(layout=layout["name"], bit=file.stem):
                        done = subprocess.run([TDBD, "bit", file, "-o", folder / file.stem], capture_output=True, text=True)
                        self.assertEqual(done.returncode, 0, done.stderr)
                    differ += file.read_bytes() != (ROOT / "validation/bits" / file.name).read_bytes()
                self.assertGreaterEqual(differ, 2, layout["name"])

    def test_another_verdict_stands_out(self):
        row = {"name": "n", "law": "l", "mean_error": "0.1", "rms_error": "0.1", "verdict": "fails"}
        text = layouts.markdown([row | {"layout": layouts.OURS},
                                 row | {"layout": "flat", "mean_error": "0.2", "verdict": "within the floor"},
                                 row | {"layout": "deep", "mean_error": "0.3"}])
        self.assertEqual(text.splitlines()[2], "| n | l | +10 % | **+20 %** | +30 % |")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
