"""watch.py, build.py, tests.py: a made-up program passes, fails, crashes, hangs, or runs no test; commands are taken apart."""

import os
import pathlib
import subprocess
import tempfile
import unittest
import unittest.mock

import build
import scripts
import tests
import watch
from rooms import ROOT

# Says what a GoogleTest program would say of tests that are called after what they do.
PROGRAM = """#!/bin/bash
for word in "$@"; do case $word in --gtest_filter=*) names=${word#*=} ;; esac; done
IFS=:
count=0
for name in $names; do
  [ "$name" = A.none ] && continue
  count=$((count + 1))
  echo "[ RUN      ] $name"
  case $name in
    A.fails) echo "[  FAILED  ] $name (1 ms)"; echo "[==========] $count tests from 1 test suite ran."; exit 1 ;;
    A.crashes) kill -SEGV $$ ;;
    A.hangs) while :; do :; done ;;
    A.child) bash -c 'while :; do :; done' ;;
    A.waits) sleep 20 ;;
    A.exits) exit 0 ;;
  esac
done
echo "[==========] $count tests from 1 test suite ran. (1 ms total)"
"""


class Watch(unittest.TestCase):
    def outcome(self, *names):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            program.write_text(PROGRAM, encoding="utf-8")
            os.chmod(program, 0o700)
            return watch.run_tests(program, names, lambda test: 0.3, {}, folder)

    def test_tells_how_a_program_ends(self):
        self.assertEqual(self.outcome("A.a", "A.b"), watch.Outcome("passed", "", 2))
        self.assertEqual(self.outcome("A.a", "A.fails", "A.b"), watch.Outcome("failed", "A.fails", 2))
        self.assertEqual(self.outcome("A.a", "A.crashes"), watch.Outcome("crashed", "A.crashes", 2))
        self.assertEqual(self.outcome("A.a", "A.hangs"), watch.Outcome("timed out", "A.hangs", 2))

    def test_time_of_the_programs_that_it_calls_counts(self):
        self.assertEqual(self.outcome("A.child"), watch.Outcome("timed out", "A.child", 1))

    def test_a_test_that_only_waits_is_stopped(self):
        with unittest.mock.patch("watch.IDLE", 0.5):
            self.assertEqual(self.outcome("A.waits"), watch.Outcome("timed out", "A.waits", 1))

    def test_a_program_that_leaves_in_the_middle_of_a_test_has_not_passed(self):
        self.assertEqual(self.outcome("A.exits").verdict, "crashed")

    def test_a_filter_that_runs_nothing_is_an_error(self):
        with self.assertRaises(ValueError):
            self.outcome("A.none")


class Commands(unittest.TestCase):
    def test_a_compile_command_keeps_its_flags_alone(self):
        command = "cmake -E env X=1 ccache /usr/bin/c++ -DA -O1 -Werror -include pch.hxx -MD -MT a.o -MF a.d -o src/a.o -c /r/src/a.cpp"
        self.assertEqual(build.compile_words(command, "/r/src/a.cpp"), "/usr/bin/c++ -DA -O1 -Werror -include pch.hxx".split())

    def test_the_mutated_object_comes_before_the_libraries(self):
        words = build.link_words(": && /usr/bin/c++ -O1 t/x.o -o verify/verify_a lib/liba.a && cd /b && cmake -P x", "verify_a")
        self.assertEqual(build.with_object(words, "src/a.o", "/tmp/m.o"), "/usr/bin/c++ -O1 /tmp/m.o t/x.o -o verify/verify_a lib/liba.a".split())

    def test_an_object_that_is_linked_by_name_is_replaced(self):
        self.assertEqual(build.with_object("c++ src/a.o src/b.o -o tdbd".split(), "src/a.o", "/tmp/m.o"), "c++ /tmp/m.o src/b.o -o tdbd".split())

    def test_the_mutant_counts_where_the_librarys_object_is_linked_as_well(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("main", "int f(); int g(); int main() { return 10 * f() + g(); }"), ("both", "int f() { return 1; } int g() { return 3; }"),
                               ("mutant", "int f() { return 2; }")):
                source = pathlib.Path(folder) / f"{name}.cpp"
                source.write_text(text, encoding="utf-8")
                subprocess.run(["c++", "-c", source.name], cwd=folder, check=True)
            subprocess.run(["ar", "rc", "lib.a", "both.o"], cwd=folder, check=True)
            words = build.with_object(["c++", "main.o", "-o", "program", "lib.a"], "both.o", "mutant.o")
            subprocess.run([*words, build.FIRST_COUNTS], cwd=folder, check=True)
            self.assertEqual(subprocess.run([f"{folder}/program"], check=False).returncode, 23)


class Scripts(unittest.TestCase):
    def test_are_met_by_the_command_line_and_sweeps_its_own_first(self):
        self.assertEqual(scripts.of_file("src/app/mesh_command.cpp"),
                         (["mesh_command"], ["bit_command", "closed_pipe", "completion_test", "cone_command", "manual_test", "new_command", "sweep_command",
                                             "terminal"]))
        self.assertEqual(scripts.of_file("src/app/manual.cpp")[0], ["manual_test"])
        self.assertEqual(scripts.of_file("src/sweep/table/journal.cpp"), ([], ["sweep_command"]))
        self.assertEqual(scripts.of_file("src/mesh/edit.cpp"), ([], []))

    def test_have_the_inputs_of_the_test(self):
        told = "".join((ROOT / f"verification/{room}/CMakeLists.txt").read_text(encoding="utf-8") for room in ("app", "sweep"))
        self.assertRegex(told, r'\$\{page\}_test\.py" \$<TARGET_FILE:tdbd>\)')
        for name in scripts.PRINTED:
            self.assertRegex(told, rf"foreach\(page [a-z ]*{name.removesuffix('_test')}\b")
            self.assertTrue(scripts.path_of(name).is_file())
        for name in (*scripts.INPUTS, *scripts.WRITE):
            given = rf"PROJECT_SOURCE_DIR\}}/{scripts.INPUTS[name]}" if name in scripts.INPUTS else r"CMAKE_CURRENT_BINARY_DIR\}/\w+"
            self.assertRegex(told, rf'{name}\.py" \$<TARGET_FILE:tdbd>\s+"\$\{{{given}"\)')
            self.assertTrue(scripts.path_of(name).is_file())

    def test_fail_with_a_program_that_is_wrong_and_end_with_one_that_waits(self):
        with tempfile.TemporaryDirectory() as folder:
            waits = pathlib.Path(folder) / "waits"
            waits.write_text("#!/bin/bash\nsleep 60\n", encoding="utf-8")
            waits.chmod(0o755)
            self.assertEqual(scripts.run("closed_pipe", "/bin/false", folder, 60.0).verdict, "failed")
            self.assertEqual(scripts.run("closed_pipe", waits, folder, 0.5).verdict, "timed out")


class Stages(unittest.TestCase):
    def test_own_tests_come_first_then_near_ones_then_quick_ones_then_other_programs(self):
        own = min(tests.own_tests("src/rock/section/section.cpp"))
        near = min(tests.near_tests("src/rock/section/section.cpp") - tests.own_tests("src/rock/section/section.cpp"))
        seconds = {"verify_rock": {"A.slow": 9.0, ".".join(near): 3.0, ".".join(own): 5.0, "A.quick": 0.001, "A.medium": 1.0},
                   "verify_simulation": {"B.b": 0.1}}
        self.assertEqual(list(tests.stages((["verify_rock"], ["verify_simulation"]), "src/rock/section/section.cpp", seconds)),
                         [("verify_rock", [".".join(own)]), ("verify_rock", [".".join(near)]), ("verify_rock", ["A.quick"]), ("verify_rock", ["A.medium"]),
                          ("verify_rock", ["A.slow"]), ("verify_simulation", ["B.b"])])

    def test_what_killed_it_before_comes_first_where_it_is_still_there(self):
        seconds = {"verify_rock": {"A.slow": 9.0, "A.quick": 0.001}}
        for first, got in (("verify_rock A.slow", ["A.slow"]), ("verify_rock A.gone", ["A.quick"]), ("verify_mesh A.slow", ["A.quick"]), ("", ["A.quick"])):
            self.assertEqual(next(tests.stages((["verify_rock"], []), "src/rock/none.cpp", seconds, first)), ("verify_rock", got))
        self.assertEqual(scripts.of_file("src/app/mesh_command.cpp", "verify_app terminal.py")[0], ["terminal", "mesh_command"])
        self.assertEqual(scripts.of_file("src/sweep/table/journal.cpp", "verify_app sweep_command.py"), (["sweep_command"], []))

    def test_an_instance_of_a_suite_is_its_own(self):
        self.assertTrue(tests.is_own("Formats/WholeBit.keeps/0", {("WholeBit", "keeps")}))
        self.assertFalse(tests.is_own("WholeBits.keeps", {("WholeBit", "keeps")}))


if __name__ == "__main__":
    unittest.main()
