"""bit_animation.py TDBD ROOT: the rigid bit of a run is written once with its poses. bit_poses.csv takes the mesh of `tdbd bit` to where the
run's motion has it, and VTK's own reader of glTF plays bit.glb to the same places."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkGLTFReader

PROGRAM, ROOT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "reports"))
from figures import bit_motion, rock_data  # noqa: E402

SETTINGS = ("rock.edge_length=8 mm", "time.step=5 ms", "time.revolutions=0.3", "output.frames_every=10")
EXACT = 1e-14  # m: places of some 0.1 m, three roundings
SINGLE = 1e-7  # m: places of 0.3 m in single precision, half a unit is 1.5e-8; 3e-8 seen
LATER = 1e-4  # s after a frame, which holds until the next


def run(case, out):
    subprocess.run([PROGRAM, "run", ROOT / "cases" / case, "-o", out, "--quiet", *(w for s in SETTINGS for w in ("--set", s))], check=True)


def played(path, times):
    """The points of an animation at each time, block after block, as VTK has them."""
    reader = vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.SetFrameRate(1000)
    reader.UpdateInformation()
    assert reader.GetNumberOfAnimations() == 1
    reader.EnableAnimation(0)
    reader.UpdateInformation()
    for time in times:
        reader.UpdateTimeStep(time + LATER)
        blocks, points = reader.GetOutput().NewIterator(), []
        blocks.InitTraversal()
        while not blocks.IsDoneWithTraversal():
            points.append(vtk_to_numpy(blocks.GetCurrentDataObject().GetPoints().GetData()).copy())
            blocks.GoToNextItem()
        yield np.concatenate(points)


class Animation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        for case in ("bit-r-rolling", "bit-b-whirl"):
            run(f"{case}.toml", cls.folder / case)

    def exported(self, bit):
        """The mesh of a bit file, at rest in its own frame."""
        out = self.folder / bit
        subprocess.run([PROGRAM, "bit", ROOT / f"cases/bits/{bit}.toml", "-o", out, "--force"], check=True, capture_output=True)
        return rock_data.read(out / "bit.vtp")

    def test_the_mesh_is_written_once(self):
        for case in ("bit-r-rolling", "bit-b-whirl"):
            self.assertEqual([f.name for f in (self.folder / case / "frames").glob("bit*")], ["bit_final.vtp"])
            self.assertEqual(len(bit_motion.poses(self.folder / case)), len(rock_data.frames(self.folder / case)))

    def test_poses_take_the_bit_to_where_it_is(self):
        for case, bit in (("bit-r-rolling", "bit-r"), ("bit-b-whirl", "bit-b")):
            mesh, poses = self.exported(bit), bit_motion.poses(self.folder / case)
            end = rock_data.final(self.folder / case, "bit")
            now = bit_motion.moved(mesh.points, bit_motion.bodies_of(mesh), poses[-1][1])
            self.assertLess(np.abs(now - end.points).max(), EXACT)
            self.assertGreater(np.abs(now - mesh.points).max(), 0.01, "the bit stood still: nothing was tested")

    def test_poses_follow_the_history(self):
        """Of a bit that whirls: its origin at each frame."""
        rows = np.genfromtxt(self.folder / "bit-b-whirl/history.csv", delimiter=",", names=True)
        for time, poses in bit_motion.poses(self.folder / "bit-b-whirl"):
            row = rows[np.argmin(np.abs(rows["time_s"] - time))]
            np.testing.assert_array_equal(poses[0][:, 3], [row[f"position_{axis}_m"] for axis in "xyz"])

    def test_vtk_plays_the_same_places(self):
        for case, bit in (("bit-r-rolling", "bit-r"), ("bit-b-whirl", "bit-b")):
            mesh, poses = self.exported(bit), bit_motion.poses(self.folder / case)
            bodies, kinds = bit_motion.bodies_of(mesh), np.zeros(len(mesh.points), int)
            kinds[mesh.triangles.ravel()] = np.repeat(mesh.cell_values["kind"].astype(int), 3)
            order = np.lexsort((np.arange(len(bodies)), kinds, bodies))  # as the file has them
            for (_, pose), points in zip(poses, played(self.folder / case / "bit.glb", [t for t, _ in poses]), strict=True):
                now = bit_motion.moved(mesh.points, bodies, pose)[order]
                self.assertEqual(points.shape, now.shape)
                self.assertLess(np.abs(points - now).max(), SINGLE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
