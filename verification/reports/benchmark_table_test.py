"""benchmark_table_test.py ROOT: benchmarks/table.py takes what a program measured and shows it."""

import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "benchmarks"))
import table  # noqa: E402

ENTRY = {"program": "step", "name": "step/a", "what": "a step", "value": None, "unit": "ms", "read": "cpu_time", "date": None}
RESULT = {"context": {"date": "2026-01-02T03:04:05"},
          "benchmarks": [{"run_name": "step/a/iterations:9", "cpu_time": 1234.5, "time_unit": "us", "triangles": 119446.0},
                         {"run_name": "step/b", "cpu_time": 1.0, "time_unit": "us"}]}


class Table(unittest.TestCase):
    def taken(self, result):
        measured = {"benchmarks": [dict(ENTRY)]}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "result.json"
            file.write_text(json.dumps(result), encoding="utf-8")
            table.take(measured, file)
        return measured

    def test_shows_time_date_and_the_rocks_size(self):
        self.assertIn("| `step` | `step/a` | a step, 119446 triangles | 1.23 ms |  | 2026-01-02 |\n", table.table(self.taken(RESULT)))

    def test_shows_what_was_never_measured(self):
        self.assertIn("| a step | not measured |  |  |\n", table.table({"benchmarks": [ENTRY]}))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
