"""records_test.py TDBD ROOT: the records of chapter 6 agree with those that this program's laboratory makes.

Without this test, a change of the program would only be noticed when the whole report is made.
"""

import pathlib
import sys
import tempfile

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "validation/chapter6"))
import lab_runs  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    program = lab_runs.Program(pathlib.Path(PROGRAM), pathlib.Path(folder) / "cuts")
    try:
        lab_runs.make_records(program, folder, record=False)
    except lab_runs.Failure as failure:
        sys.exit(str(failure))
