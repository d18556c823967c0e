"""What a result holds: figures, history, rock, pictures; folders of others and temporary ones; check and converge."""

import copy
import io
import json
import multiprocessing
import os
import pickle
import shutil
import subprocess
import sys
import unittest

from common import CONES, DRILLING, PACKAGES, QUICK, TOP, FolderTest, command, words

import numpy as np
import tdbd


def picture(figure):
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=50)
    return buffer.getvalue()


class Results(FolderTest):
    def test_a_run(self):
        result = tdbd.run(tdbd.case(DRILLING, set=QUICK), self.folder / "a")
        self.assertEqual(result.summary, json.loads((self.folder / "a/summary.json").read_text()))
        self.assertEqual(result.timing["threads"], 1)
        history = result.history
        self.assertEqual(history["time"].size, 20)
        self.assertEqual(history["removed_volume_total"].values[-1], result.summary["removed_volume_m3"])
        self.assertEqual(history["removed_volume_total"].attrs["units"], "m3")
        self.assertEqual(history["removed_volume_by_part"].dims, ("time", "part"))
        n = len(result.rock.vertices)
        self.assertEqual((result.rock.vertices.shape, result.rock.faces.shape), ((n, 3), (result.summary["rock_triangles_end"], 3)))
        self.assertIs(result.rock, result.rock)
        faces = history["removed_volume_by_part"].sel(part="cutter-1/face")
        self.assertEqual((faces.dims, str(history["part_kind"].sel(part="cutter-1/face").values)), (("time",), "face"))
        self.assertRaises(KeyError, history.sel, part="cutter-1/nose")
        self.assertTrue(picture(result.plot()).startswith(b"\x89PNG"))
        self.assertIn("completed", repr(result))

    def test_a_plot_is_clipped_to_the_hole(self):
        """Axes and colours span the hole, not the block of rock around it."""
        result = tdbd.run(tdbd.case(DRILLING, set=QUICK | {"rock.shape": "flat", "rock.radius": "160 mm"}))
        hole = result.plot().axes[0]
        radius = 1e3 * result.summary["gage_radius_m"]
        rock = 1e3 * np.abs(result.rock.vertices[:, :2]).max()
        self.assertGreater(rock, 1.3 * radius)
        for low, high in (hole.get_xlim(), sorted(hole.get_ylim())):
            self.assertTrue(-1.1 * radius < low < -radius and radius < high < 1.1 * radius, (low, high, radius))
        self.assertGreater(hole.get_ylim()[0], hole.get_ylim()[1])  # y down

    def test_history_is_labelled_by_cone(self):
        result = tdbd.run(tdbd.case(CONES, set=QUICK))
        self.assertEqual(result.history["cone_angle"].sel(cone="cone-2").dims, ("time",))

    def test_a_rotation(self):
        result = tdbd.rotate(tdbd.case(TOP, time__duration="2 s"))
        self.assertEqual(result.history["axis_W"].dims, ("time", "xyz"))
        self.assertTrue(picture(result.plot()).startswith(b"\x89PNG"))

    def test_folders_of_the_command_line(self):
        command("run", DRILLING, *words(QUICK), "-o", self.folder / "run", "--quiet")
        command("rotate", TOP, "-o", self.folder / "rotate", "--quiet")
        self.assertIsInstance(tdbd.load(self.folder / "run"), tdbd.RunResult)
        self.assertIsInstance(tdbd.load(self.folder / "rotate"), tdbd.RotationResult)
        with self.assertRaisesRegex(FileNotFoundError, "table.nc: found no folder with summary.json, .* tdbd.sweep.load"):
            tdbd.load(self.folder / "table.nc")
        self.assertRaises(FileNotFoundError, tdbd.load, self.folder / "none")

    def test_a_temporary_folder_goes_with_its_result(self):
        result = tdbd.rotate(tdbd.case(TOP, time__duration="1 s"))
        folder = result.folder
        self.assertTrue(folder.is_dir())
        del result
        self.assertFalse(folder.parent.exists())

    def test_a_path_in_place_of_a_case(self):
        os.chdir(self.folder)
        resolved = tdbd.case(DRILLING, set=QUICK)
        (self.folder / "again.toml").write_text(resolved.resolved)
        self.assertEqual(tdbd.run("again.toml").summary["case_hash"], resolved.hash)
        self.assertEqual(resolved.replace(time__revolutions=0.1).steps, 10)
        self.assertEqual(resolved.replace(time__revolutions=0.1).quantities["rock.edge_length"], 8e-3)

    def test_cases_go_to_other_processes(self):
        case = tdbd.case(DRILLING, set=QUICK)
        again = pickle.loads(pickle.dumps(case))
        self.assertEqual((again.hash, again.overrides), (case.hash, case.overrides))
        drill = "import pickle, sys, tdbd; print(tdbd.run(pickle.load(sys.stdin.buffer)).summary['steps'])"
        done = subprocess.run([sys.executable, "-B", "-c", drill], input=pickle.dumps(case), capture_output=True, check=True,
                              env=os.environ | {"PYTHONPATH": str(PACKAGES)})
        self.assertEqual(done.stdout.strip(), b"20")

    def test_results_return_from_other_processes(self):
        """The files of a temporary folder travel with their result; the worker and its folder are gone."""
        cases = [tdbd.case(TOP, time__duration=f"{n} s") for n in (1, 2)]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            results = pool.map(tdbd.rotate, cases)
        rotate = "import pickle, sys, tdbd; pickle.dump(tdbd.rotate(pickle.load(sys.stdin.buffer)), sys.stdout.buffer)"
        done = subprocess.run([sys.executable, "-B", "-c", rotate], input=pickle.dumps(cases[0]), capture_output=True, check=True,
                              env=os.environ | {"PYTHONPATH": str(PACKAGES)})
        for n, result in zip((1, 2, 1), [*results, pickle.loads(done.stdout)]):
            self.assertEqual(result.summary["duration_s"], n)
            self.assertEqual(result.history["time"].values[-1], n)

    def test_results_are_pickled_and_copied(self):
        result = tdbd.run(tdbd.case(DRILLING, set=QUICK))
        volume, n = result.summary["removed_volume_m3"], len(result.rock.vertices)
        same, pickled = copy.deepcopy(result), pickle.dumps(result)
        self.assertEqual(same.folder, result.folder)
        del result
        self.assertEqual(len(same.rock.vertices), n)  # the copy keeps the folder
        folder = same.folder
        del same
        self.assertFalse(folder.exists())
        again = pickle.loads(pickled)
        self.assertEqual((again.summary["removed_volume_m3"], len(again.rock.vertices)), (volume, n))
        kept = tdbd.rotate(tdbd.case(TOP, time__duration="1 s"), self.folder / "kept")
        pickled = pickle.dumps(kept)
        self.assertLess(len(pickled), 1000)  # the path only
        self.assertEqual(pickle.loads(pickled).folder, kept.folder)
        shutil.rmtree(kept.folder)
        self.assertRaisesRegex(FileNotFoundError, "moved or deleted", pickle.loads, pickled)

    def test_a_fork_does_not_delete_the_folder(self):
        result = tdbd.rotate(tdbd.case(TOP, time__duration="1 s"))
        child = os.fork()
        if child == 0:
            del result  # deletes the temporary folder in the process that made it only
            os._exit(0)
        os.waitpid(child, 0)
        self.assertTrue(result.folder.is_dir())

    def test_a_simulation_cannot_be_pickled(self):
        for simulation in (tdbd.Simulation(tdbd.case(DRILLING, set=QUICK)), tdbd.Rotation(TOP)):
            for use in (pickle.dumps, copy.copy, copy.deepcopy):
                self.assertRaisesRegex(TypeError, "between two steps cannot be copied", use, simulation)

    def test_a_relative_folder_stays_where_it_was(self):
        os.chdir(self.folder)
        result = tdbd.rotate(tdbd.case(TOP, time__duration="1 s"), "a")
        os.chdir("/")
        self.assertEqual(result.folder, self.folder / "a")
        self.assertEqual(result.summary["status"], "completed")

    def test_check(self):
        found = tdbd.check(tdbd.case(DRILLING, set=QUICK))
        told = command("check", DRILLING, *words(QUICK)).stdout
        self.assertIn(f"{found['triangles']} triangles of rock", told)
        self.assertGreater(min(found[key] for key in ("triangles_at_end", "memory_bytes", "disk_bytes", "seconds", "steps_tried")), 0)
        self.assertEqual(tdbd.check(TOP)["cones"], 0)

    def test_converge(self):
        heard = []
        study = tdbd.converge(tdbd.case(TOP, time__duration="2 s"), ["time.step"], levels=6, progress=lambda *at: heard.append(at))
        np.testing.assert_allclose(study.sizes, 0.01 / 2.0 ** np.arange(6))
        self.assertTrue(all(abs(order - 2) < 0.02 for order in study.orders.values() if order is not None), study.table)
        self.assertGreater(sum(order is not None for order in study.orders.values()), 3)
        self.assertTrue(all(errors.shape == (5,) for errors in study.errors.values()))
        self.assertTrue(picture(study.plot()).startswith(b"\x89PNG"))
        self.assertTrue(heard)
        golden = tdbd.rotate(tdbd.case(TOP, time__duration="2 s", time__step="0.1 ms", integrator__order=4), self.folder / "golden")
        against = tdbd.converge(tdbd.case(TOP, time__duration="2 s"), "time.step", 3, reference=golden.folder)
        self.assertTrue(all(errors.shape == (3,) for errors in against.errors.values()))


if __name__ == "__main__":
    unittest.main(warnings="ignore")
