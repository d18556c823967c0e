"""A simulation in a user's hands: the same numbers as a run, arrays that are copies, steps that end with the case."""

import unittest

from common import CONES, DRILLING, DRIVEN, QUICK, TOP, FolderTest

import numpy as np
import tdbd


class Drilling(FolderTest):
    def test_steps_are_those_of_a_run(self):
        for case in (tdbd.case(DRILLING, set=QUICK), tdbd.case(CONES, set=QUICK),
                     tdbd.case(DRIVEN, rock__edge_length="6 mm", time__duration="0.03 s", output__energy_order="off")):
            with self.subTest(case.path):
                sim = tdbd.Simulation(case, threads=2)
                made = [sim.step(np.int64(7)), sim.step(0), sim.step(10**9), sim.step()]
                self.assertEqual((sum(made), made[1], made[3]), (case.steps, 0, 0))
                self.assertTrue(sim.done)
                result = tdbd.run(case)
                np.testing.assert_array_equal(sim.rock.vertices, result.rock.vertices)
                np.testing.assert_array_equal(sim.rock.faces, result.rock.faces)
                for key, value in sim.summary.items():
                    if key != "energy_residual_order_of":  # a run measures it on request
                        self.assertEqual(value, result.summary[key], key)
                self.assertEqual(sim.time, result.history["time"].values[-1])
                np.testing.assert_array_equal(sim.position, [result.history[f"position_{x}"].values[-1] for x in "xyz"])

    def test_arrays(self):
        case = tdbd.case(CONES, set=QUICK | {"time.revolutions": 1})
        sim = tdbd.Simulation(case)
        self.assertEqual((sim.time, sim.steps_done, sim.removed_volume, sim.done), (0.0, 0, 0.0, False))
        self.assertEqual(sim.step(90), 90)
        n, m = len(sim.rock.vertices), len(sim.rock.faces)
        for array, shape, kind in ((sim.rock.vertices, (n, 3), float), (sim.rock.faces, (m, 3), np.int32), (sim.rock.depth, (n,), float),
                                   (sim.last_part, (n,), np.int32), (sim.position, (3,), float), (sim.rotation, (3, 3), float),
                                   (sim.force, (3,), float), (sim.torque, (3,), float), (sim.removed_by_part, (len(case.parts),), float),
                                   (sim.removed_in_step, (len(case.parts),), float), (sim.cone_angles, (3,), float), (sim.cone_speeds, (3,), float)):
            self.assertEqual((array.shape, array.dtype), (shape, kind))
        self.assertEqual((sim.rock.faces.min(), sim.rock.faces.max()), (0, n - 1))
        self.assertEqual((sim.last_part.min(), sim.last_part.max() < len(case.parts)), (-1, True))
        self.assertAlmostEqual(sim.removed_by_part.sum(), sim.removed_volume, delta=1e-12 * sim.removed_volume)
        self.assertGreater(sim.removed_volume, 0)
        self.assertLess(sim.volume_ledger_defect, 1e-12)
        angle = 2 * np.pi * sim.revolutions
        np.testing.assert_allclose(sim.rotation, [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]], atol=1e-12)

    def test_arrays_are_copies(self):
        sim = tdbd.Simulation(tdbd.case(DRILLING, set=QUICK))
        sim.step(5)
        before, place = sim.rock, sim.position
        kept = before.vertices.copy()
        sim.step(5)
        np.testing.assert_array_equal(before.vertices, kept)
        self.assertFalse(np.array_equal(place, sim.position))
        after = sim.rock.vertices
        sim.rock.vertices[:] = 0.0
        np.testing.assert_array_equal(sim.rock.vertices, after)
        del sim
        np.testing.assert_array_equal(before.vertices, kept)
        self.assertTrue(before.vertices.flags.owndata or before.vertices.base is not None)

    def test_forces(self):
        sim = tdbd.Simulation(tdbd.case(DRIVEN, rock__edge_length="6 mm", time__duration="0.03 s"))
        np.testing.assert_array_equal(sim.force, 0.0)
        sim.step(10**6)
        self.assertLess(sim.force[2], 0.0)  # the rock bears the weight: up, against z
        self.assertLess(sim.torque[2], 0.0)  # and holds the bit back

    def test_progress(self):
        heard = []
        sim = tdbd.Simulation(tdbd.case(DRILLING, set=QUICK))
        sim.step(20, progress=lambda done, total: heard.append((done, total, sim.steps_done)))
        self.assertEqual(heard[-1], (20, 20, 20))

        def stop(done, total):
            raise KeyError("enough")

        sim = tdbd.Simulation(tdbd.case(DRILLING, set=QUICK))
        self.assertRaises(KeyError, sim.step, 20, stop)
        self.assertEqual(sim.steps_done, 20)


class Rotating(FolderTest):
    def test_steps_are_those_of_a_rotation(self):
        case = tdbd.case(TOP, time__duration="3 s")
        body = tdbd.Rotation(case)
        energy = body.energy
        self.assertEqual((body.step(1), body.step(10**9), body.step(), body.done), (1, case.steps - 1, 0, True))
        result = tdbd.rotate(case)
        self.assertEqual(body.summary, result.summary)
        np.testing.assert_array_equal(body.quaternion, result.history["quaternion"].values[-1])
        np.testing.assert_array_equal(body.rotation, result.summary["attitude"])
        np.testing.assert_array_equal(body.angular_velocity, result.summary["angular_velocity"])
        np.testing.assert_array_equal(body.momentum, result.summary["space_momentum"])
        self.assertEqual((body.time, body.energy), (result.summary["duration_s"], result.summary["energy_end"]))
        self.assertEqual(energy, result.summary["energy_start"])
        self.assertEqual((body.cone_angles.shape, body.cone_momenta.shape), ((0,), (0,)))
        self.assertRaisesRegex(ValueError, "steps: found -2", body.step, -2)


if __name__ == "__main__":
    unittest.main(warnings="ignore")
