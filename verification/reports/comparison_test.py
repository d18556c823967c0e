"""comparison_test.py: the comparison with earlier models is shown, made once, made again when it changed; verdicts follow the numbers."""

import shutil
import sys
import tempfile
import unittest

from small_project import REPORTS, Project

sys.path.insert(0, str(REPORTS))
import comparison_tables  # noqa: E402
from comparison import protocol  # noqa: E402
import comparison_results  # noqa: E402

PROTOCOL = """
[runs.bit-b]
case = "cases/compare/b.toml"
models = ["tdbd", "behr"]
sweep = {"motion.rate_of_penetration" = ["15 m/h"]}
"""
# A tdbd-compare with two models: that of Behr returns FACTOR times the weight of TDBD, and no wear.
COMPARE = """#!/usr/bin/python3
import json, math, pathlib, sys, time
import netCDF4
out = pathlib.Path(sys.argv[sys.argv.index("-o") + 1])
says = {"tdbd": {"weight": 1000.0, "torque": 20.0}, "behr": {"weight": 1000.0 * FACTOR, "torque": 20.0}}
units = {"weight": "N", "torque": "N m", "largest_wear_flat": "m2"}
rows = [",".join([m, q, u, str(says[m][q]) + "," if q in says[m] else ',"no law, of wear"']) for m in says for q, u in units.items()]
(out / "comparison.csv").write_text("model,quantity,unit,value,reason\\n" + "\\n".join(rows) + "\\n")
(out / "parts.csv").write_text("model,part,radius_m,quantity,unit,value\\n" + "".join(f"{m},cutter-1,0.05,area,m2,1e-5\\n" for m in says))
(out / "timing.json").write_text(json.dumps({"models": {m: {"cpu_s": 1.0 + time.time() % 1.0, "simulated_s": 1.0, "steps": 10} for m in says}}))
(out / "comparison.json").write_text(json.dumps({
    "units": units, "advance_m_per_revolution": 2e-3, "gage_radius_m": 0.1, "rotary_speed_rad_per_s": 12.0, "reference_weight_n": 1000.0,
    "models": [{"name": "tdbd", "title": "TDBD"}, {"name": "behr", "title": "Behr et al."}]}))
with netCDF4.Dataset(out / "comparison.nc", "w") as file:
    file.createDimension("model", 2)
    file.createDimension("circle_sample", 360)
    names = file.createVariable("model", str, ("model",))
    for i, m in enumerate(says):
        names[i] = m
    file.createVariable("circle_samples", "f8", ("model",))[:] = [360.0, 0.0]
    file.createVariable("bottom_depth", "f8", ("model", "circle_sample"))[0] = [1e-3 * math.cos(73 * math.radians(k)) for k in range(360)]
"""


COSTS = "run,model,cpu_s,simulated_s\nbit-b/15m/h,tdbd,3.0,1.5\nbit-b/15m/h,behr,0.01,0.0\n"


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = Project(folder.name)
        for script in [REPORTS / "figures/style.py", REPORTS / "figures/compare.py"]:
            shutil.copy(script, self.project.root / "reports/figures")
        self.project.write("reports/protocol.toml", PROTOCOL)
        self.project.write("reports/comparison_costs.csv", COSTS)
        self.project.write("cases/compare/b.toml", "[bit]\n")
        self.give("1.01")

    def give(self, factor):
        self.project.write("build/release/tdbd-compare", COMPARE.replace("FACTOR", factor)).chmod(0o755)

    def make(self, *words, arguments=()):
        """Whether a comparison was made; complaints contain these words."""
        return "made comparison (" in self.project.make_or_complain(self, words, arguments)

    def page(self, folder=None):
        return ((folder or self.project.out) / "index.html").read_text(encoding="utf-8")

    def section(self, place):
        return self.page().split(f'<section id="calibration-comparison-{place}">')[1].split("</section>")[0]

    def test_is_made_once_and_shown(self):
        self.assertTrue(self.make())
        self.assertFalse(self.make())
        self.assertFalse(self.make(arguments=("--check",)))
        self.assertIn("no law, of wear", self.section("table-cannot-say"))
        self.assertIn("Behr et al.", self.section("table-numbers"))
        self.assertIn('src="data:image/png;base64,', self.section("figure-compare_areas"))

    def test_verdicts_follow_the_numbers(self):
        self.make()
        self.assertRegex(self.section("table-expected"), r"worst 1 % \(Behr et al\., bit B at 2 mm\)</td>\s*<td>as expected")
        self.give("1.2")
        self.assertTrue(self.make())
        self.assertRegex(self.section("table-expected"), r"worst 20 % \(.*?\)</td>\s*<td><strong>not as expected")

    def test_made_from_nothing_it_has_the_same_bytes_whatever_the_runs_cost(self):
        made = []
        for _ in range(2):
            self.assertTrue(self.make())
            made.append({p.name: p.read_bytes() for p in (self.project.out / "comparison").iterdir() if p.suffix in (".md", ".png")})
            shutil.rmtree(self.project.out / "comparison")
        self.assertEqual(made[0], made[1])
        self.assertIn(b"| CPU time over simulated time, measured once | 2 | \xe2\x80\x93 |", made[0]["numbers.md"])

    def test_a_run_whose_cost_was_never_measured_is_named(self):
        self.project.write("reports/comparison_costs.csv", COSTS.replace("bit-b/15m/h", "bit-b/7.2m/h"))
        self.make("comparison_costs.csv: found no processor time of the run bit-b/15m/h", "reports/comparison_results.py")
        self.project.write("reports/comparison_costs.csv", COSTS + "bit-b/15m/h,behr,much,1.0\n")
        self.make("comparison_costs.csv:4: found 'bit-b/15m/h,behr,much,1.0', expected run,model,cpu_s,simulated_s")
        self.project.write("reports/comparison_costs.csv", COSTS.replace("3.0", "4.5"))
        self.assertTrue(self.make())
        self.assertIn("<td>3</td>", self.section("table-numbers"))

    def test_is_made_again_when_a_case_or_a_bit_changed(self):
        self.make()
        for file in ("cases/compare/b.toml", "cases/bits/bit-b.toml", "reports/figures/compare.py"):
            with self.subTest(file):
                path = self.project.root / file
                self.project.write(file, (path.read_text(encoding="utf-8") if path.is_file() else "") + "\n# another\n")
                self.assertTrue(self.make())
                self.assertFalse(self.make())

    def test_that_fails_or_is_not_built_leaves_no_report(self):
        self.project.write("build/release/tdbd-compare", "#!/bin/sh\necho wrong case >&2\nexit 2\n").chmod(0o755)
        self.make("exit code 2", "wrong case")
        (self.project.build / "tdbd-compare").unlink()
        self.make("tdbd-compare is not built")
        self.assertFalse((self.project.out / "index.html").exists())

    def test_waves_of_the_bottom_are_counted(self):
        self.make()
        result = comparison_results.Result(self.project.out / "comparison/data/bit-b/15m/h")
        self.assertEqual(result.strongest("tdbd", 1), [73])
        self.assertAlmostEqual(result.harmonics("tdbd")[73], 1e-3)
        self.assertIsNone(result.strongest("behr", 1))
        self.assertTrue(comparison_tables.mesh_shows({"whirl-1500": [({}, result)]}, "whirl-1500", 73).holds)


class Protocol(unittest.TestCase):
    def test_names_runs_of_cases_that_exist(self):
        root = REPORTS.parent
        runs = list(protocol(REPORTS / "protocol.toml"))
        self.assertEqual(len({r.name for r in runs}), len(runs))
        for run in runs:
            self.assertTrue((root / run.case).is_file(), run.case)
        costs = comparison_results.read_costs(REPORTS / comparison_results.COSTS)
        self.assertEqual(set(costs), {r.name for r in runs})
        for run, models in costs.items():
            self.assertGreater(max(c for c in models.values() if c is not None), 0.0, run)
        groups = {r.group for r in runs}
        self.assertLessEqual({"bit-a", "bit-b", "bit-c", "bit-r", "whirl-1500", "whirl-3000"}, groups)


if __name__ == "__main__":
    unittest.main()
