"""cases_test.py PROGRAM ROOT WEB: shipped cases in both programs, under node: volumes and surface agree. Exit code 77: it was
not built."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import built
import numpy as np

PROGRAM, ROOT, WEB = map(pathlib.Path, sys.argv[1:4])
AGREE = 1e-12  # relative: of what the strongest part removed, and of a metre
STEPS = 1_000_000  # no case has more
REFUSED = {
    'rotary_speed = "120 rpm"': ('rotary_speed = "120 furlongs/s"', ("furlongs/s", "expected angular speed in rad/s")),
    'edge_length = "3 mm"': ('edge_length = "3 kg"', ("kg is mass", "length in m")),
    'kind = "steady"': ('kind = "stedy"', ("stedy",)),
}


class Cases(unittest.TestCase):
    def setUp(self):
        self.made = tempfile.TemporaryDirectory()
        self.addCleanup(self.made.cleanup)
        self.folder = pathlib.Path(self.made.name)
        subprocess.run(["cp", "-r", ROOT / "cases", self.folder], check=True)

    def write(self, text):
        (self.folder / "cases/short.toml").write_text(text, encoding="utf-8")

    def native(self):
        out = self.folder / "native"
        subprocess.run([PROGRAM, "run", self.folder / "cases/short.toml", "-o", out, "--quiet", "--force"], check=True, capture_output=True)
        return json.loads((out / "summary.json").read_text(encoding="utf-8")), built.surface(out / "rock_final.ply")

    def in_browser(self):
        rock = self.folder / "web.ply"
        return built.drilled(ROOT, WEB, self.folder / "cases", "short.toml", STEPS, rock), built.surface(rock)

    def test_drills_as_the_command_line_does(self):
        for name in built.CASES:
            with self.subTest(name):
                self.write(built.shortened(ROOT, name))
                (run, (points, triangles)), (look, (web_points, web_triangles)) = self.native(), self.in_browser()
                self.assertEqual(look["steps"], run["steps"])
                self.assertEqual(web_triangles, triangles)
                volumes, web_volumes = np.array(list(run["removed_volume_by_part_m3"].values())), np.array(look["removed_by_part_m3"])
                apart = {"m": float(np.abs(web_points - points).max()), "volumes": float(np.abs(web_volumes - volumes).max() / volumes.max())}
                print(f"{name}: {look['steps']} steps, {look['triangles']} triangles, apart {apart}")
                self.assertLess(max(apart.values()), AGREE)
                self.assertGreater(volumes.max(), 1e-8)

    def test_reports_mistakes_as_the_command_line_does(self):
        for right, (wrong, words) in REFUSED.items():
            with self.subTest(wrong):
                text = built.shortened(ROOT, "bit-b-steady")
                self.assertIn(right, text)
                self.write(text.replace(right, wrong))
                native = subprocess.run([PROGRAM, "run", self.folder / "cases/short.toml", "-o", self.folder / "no"], capture_output=True, text=True, check=False)
                self.assertEqual(native.returncode, 2)
                with self.assertRaises(built.Refused) as refused:
                    self.in_browser()
                for word in words:
                    self.assertIn(word, native.stderr)
                    self.assertIn(word, str(refused.exception))


if __name__ == "__main__":
    built.require(PROGRAM, ROOT, WEB)
    unittest.main(argv=sys.argv[:1])
