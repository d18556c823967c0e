"""Several Python threads drill independently, one at a time in one folder, and Python continues meanwhile."""

import concurrent.futures
import threading
import time
import unittest

from common import COARSE, DRILLING, LONG, QUICK, TOP, FolderTest

import numpy as np
import tdbd


class Threads(FolderTest):
    def test_results_do_not_depend_on_other_threads(self):
        """Eight at a time, with frames and checkpoints: NetCDF and HDF5 are in every one of them."""
        drilling = tdbd.case(DRILLING, set=QUICK | {"output.frames_every": 4, "output.checkpoint_every": 2})
        rotation = tdbd.case(TOP, time__duration="30 s", output__history_every=1)
        one = tdbd.run(drilling, self.folder / "drilled"), tdbd.rotate(rotation, self.folder / "rotated")
        calls = [lambda i=i: tdbd.run(drilling, self.folder / f"a{i}") for i in range(12)]
        calls += [lambda i=i: tdbd.rotate(rotation, self.folder / f"b{i}") for i in range(12)]
        reads = [lambda: one[0].history.sizes and tdbd.load(self.folder / "drilled").history for _ in range(12)]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            done = [pool.submit(call) for calls_of_both in zip(calls[:12], calls[12:], reads) for call in calls_of_both]
            for future in done:
                future.result()
        for i in range(12):
            self.same_files(one[0].folder, self.folder / f"a{i}")
            self.same_files(one[1].folder, self.folder / f"b{i}")

    def test_cases_are_read_in_threads(self):
        """UDUNITS-2 is in every one of them."""
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            read = [pool.submit(tdbd.case, DRILLING, rock__edge_length=f"{1 + i} mm", rock__wall="1.25 in") for i in range(40)]
        for i, case in enumerate(read):
            self.assertAlmostEqual(case.result().quantities["rock.edge_length"], 1e-3 * (1 + i))
            self.assertAlmostEqual(case.result().quantities["rock.wall"], 0.03175)

    def test_one_at_a_time_in_a_folder(self):
        began, stop = threading.Event(), threading.Event()

        def progress(done, total):
            began.set()
            if stop.is_set():
                raise InterruptedError

        case = tdbd.case(DRILLING, set=LONG)
        first = concurrent.futures.ThreadPoolExecutor(1).submit(tdbd.run, case, self.folder / "a", progress=progress)
        self.assertTrue(began.wait(60))
        with self.assertRaisesRegex(tdbd.FolderError, "output folder .*: in use: another command writes to it; wait until it ends"):
            tdbd.run(case, self.folder / "a", force=True)
        stop.set()
        self.assertRaises(InterruptedError, first.result, 60)
        self.assertEqual(tdbd.load(self.folder / "a").summary["status"], "interrupted")

    def test_python_threads_run_meanwhile(self):
        """A thread that only counts gets its share of the time while another one steps."""
        sim = tdbd.Simulation(tdbd.case(DRILLING, set=COARSE | {"rock.edge_length": "4 mm", "time.revolutions": 10}))
        stepping = threading.Thread(target=sim.step, args=(10**6,))
        counted = 0
        stepping.start()
        while stepping.is_alive():
            time.sleep(0.001)
            counted += 1
        self.assertGreater(counted, 20)  # of some hundred; without its lock released at most one in 0.1 s
        self.assertTrue(sim.done)

    def test_one_simulation_in_two_threads(self):
        case = tdbd.case(DRILLING, set=COARSE | {"time.revolutions": 4})
        alone, shared = tdbd.Simulation(case), tdbd.Simulation(case)
        alone.step(10**6)

        def some():
            made = 0
            while steps := shared.step(7):
                made += steps
                self.assertEqual(shared.rock.vertices.shape[1], 3)
            return made

        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            made = [pool.submit(some) for _ in range(4)]
        self.assertEqual(sum(future.result() for future in made), case.steps)
        np.testing.assert_array_equal(alone.rock.vertices, shared.rock.vertices)

    def test_the_lock_of_files(self):
        """Who holds it keeps others from writing, and may hold it twice."""
        with tdbd.FilesLock(), tdbd.FilesLock():
            other = concurrent.futures.ThreadPoolExecutor(1).submit(tdbd.rotate, tdbd.case(TOP, time__duration="1 s"))
            self.assertRaises(concurrent.futures.TimeoutError, other.result, 0.5)
        self.assertEqual(other.result(60).summary["status"], "completed")


if __name__ == "__main__":
    unittest.main(warnings="ignore")
