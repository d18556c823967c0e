"""Ctrl-C raises KeyboardInterrupt, recorded output is kept, and a resumed run is bitwise identical to an uninterrupted one."""

import os
import signal
import threading
import time
import unittest

from common import COARSE, DRILLING, LONG, TOP, FolderTest

import tdbd

signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored if this was started in the background
SOON = 0.5  # s, into a computation
LATE = 60.0  # s, in which it must have ended


class Interrupts(FolderTest):
    def interrupted(self, call):
        """Calls it, with a Ctrl-C on the way."""
        timer = threading.Timer(SOON, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        began = time.monotonic()
        self.assertRaises(KeyboardInterrupt, call)
        timer.join()
        self.assertLess(time.monotonic() - began, LATE)

    def test_a_run(self):
        self.interrupted(lambda: tdbd.run(tdbd.case(DRILLING, set=LONG | {"output.history_every": 1}), self.folder / "a"))
        result = tdbd.load(self.folder / "a")
        self.assertEqual(result.summary["status"], "interrupted")
        self.assertEqual(result.history["time"].size, result.summary["steps"])
        self.assertTrue((self.folder / "a/checkpoint.bin").is_file())

    def test_a_rotation_and_a_study(self):
        self.interrupted(lambda: tdbd.rotate(tdbd.case(TOP, time__duration="1e6 s", time__step="1 ms"), self.folder / "a"))
        self.assertEqual(tdbd.load(self.folder / "a").summary["status"], "interrupted")
        self.interrupted(lambda: tdbd.converge(tdbd.case(TOP, time__duration="1e4 s", time__step="1 ms"), "time.step", 9))

    def test_steps(self):
        sim = tdbd.Simulation(tdbd.case(DRILLING, set=LONG))
        self.interrupted(lambda: sim.step(10**9))
        made = sim.steps_done
        self.assertGreater(made, 0)
        self.assertLess(sim.volume_ledger_defect, 1e-12)
        self.assertEqual((sim.step(3), sim.steps_done), (3, made + 3))

    def goes_on(self, case, begin):
        """Interrupts a run from its progress callback and resumes it."""
        def stop(done, total):
            self.assertLess(done, total)
            raise LookupError("enough")

        whole = begin(case, self.folder / "whole")
        self.assertRaises(LookupError, begin, case, self.folder / "part", progress=stop)
        self.assertEqual(tdbd.load(self.folder / "part").summary["status"], "interrupted")
        self.assertEqual(tdbd.resume(self.folder / "part").summary["status"], "completed")
        self.same_files(whole.folder, self.folder / "part")
        self.assertEqual(tdbd.resume(self.folder / "part").summary["status"], "completed")

    def test_a_run_is_resumed(self):
        self.goes_on(tdbd.case(DRILLING, set=COARSE | {"time.revolutions": 20}), tdbd.run)
        self.assertRaises(tdbd.CaseError, tdbd.resume, self.folder / "nowhere")

    def test_a_rotation_is_resumed(self):
        self.goes_on(tdbd.case(TOP, time__duration="1e5 s"), tdbd.rotate)

    def test_a_run_and_a_rotation_have_a_later_end(self):
        for begin, case, end in ((tdbd.run, tdbd.case(DRILLING, set=COARSE | {"time.revolutions": 0.2, "output.checkpoint_every": 5}),
                                  {"time__revolutions": 0.4}),
                                 (tdbd.rotate, tdbd.case(TOP, time__duration="10 s"), {"time__duration": "20 s"})):
            with self.subTest(begin.__name__):
                short = self.folder / f"short-{begin.__name__}"
                begin(case, short)
                whole = begin(tdbd.case(short / "case.toml", **end), self.folder / f"long-{begin.__name__}")
                self.assertEqual(tdbd.resume(short, **end).summary["status"], "completed")
                self.same_files(whole.folder, short)
                self.assertRaises(tdbd.CaseError, tdbd.resume, short, time__step="1 ms")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
