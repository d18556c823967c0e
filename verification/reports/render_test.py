"""The depth buffer of reports/figures/render.py: what is nearer is seen, nothing is mirrored, areas are true."""

import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reports"))
from figures import render  # noqa: E402

CAMERA = render.Camera(toward=(0, 0, 1), up=(0, 1, 0), centre=(0, 0, 0), width=2.0, pixels=(100, 100))
RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def square(z, colour, half=0.5, x=0.0, y=0.0, owner=0):
    """Two triangles that face +z."""
    p = np.array([[x - half, y - half, z], [x + half, y - half, z], [x + half, y + half, z], [x - half, y + half, z]])
    return render.Layer(p[[[0, 1, 2], [0, 2, 3]]], np.array([colour, colour]), np.array([owner, owner]))


def sphere(n):
    """A unit sphere of 2 n (n - 1) quads or so, outward."""
    t, p = np.meshgrid(np.pi * np.arange(n + 1) / n, np.pi * np.arange(2 * n + 1) / n, indexing="ij")
    x = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1)
    a, b, c, d = x[:-1, :-1], x[1:, :-1], x[1:, 1:], x[:-1, 1:]
    corners = np.concatenate([np.stack(q, axis=2).reshape(-1, 3, 3) for q in ((a, b, c), (a, c, d))])
    return render.Layer(corners, np.ones((len(corners), 3)), np.zeros(len(corners), int))


def is_red(pixel):
    return pixel[0] > 2 * max(pixel[2], 0.05)


class Picture(unittest.TestCase):
    def test_the_nearer_triangle_is_seen_whatever_the_order(self):
        near, far = square(0.2, RED, owner=1), square(-0.2, BLUE, owner=2)
        for layers in ([near, far], [far, near]):
            self.assertTrue(is_red(render.picture(CAMERA, render.joined(layers))[50, 50]))
        self.assertFalse(is_red(render.picture(CAMERA, render.joined([square(-0.4, RED), far]))[50, 50]))
        small = [square(0.2, RED, 0.05, owner=1), square(-0.2, BLUE, 0.9, owner=2)]  # drawn in chunks of one size
        self.assertTrue(is_red(render.picture(CAMERA, render.joined(small))[50, 50]))

    def test_a_lift_decides_between_two_at_one_depth(self):
        low, high = square(0.0, BLUE), square(0.0, RED)
        high.lift = 1e-4
        for layers in ([low, high], [high, low]):
            self.assertTrue(is_red(render.picture(CAMERA, render.joined(layers))[50, 50]))

    def test_right_is_right_and_up_is_up(self):
        image = render.picture(CAMERA, square(0, RED, 0.2, 0.5, 0.5))
        self.assertTrue(is_red(image[25, 75]))
        self.assertTrue(np.all(image[75, 25] == 1.0) and np.all(image[25, 25] == 1.0))
        np.testing.assert_allclose(CAMERA.place([[0.5, 0.5, 0.3]]), [[75, 25]], atol=1e-12)

    def test_the_picture_of_a_right_handed_frame_is_right_handed(self):
        for toward, up in (((0, 0, 1), (0, 1, 0)), ((0.62, -0.62, 0.66), (0, 0, -1)), ((1, 2, 3), (3, 2, 1))):
            camera = render.Camera(toward, up, (0, 0, 0), 1.0, (10, 10))
            np.testing.assert_allclose(camera.axes() @ camera.axes().T, np.eye(3), atol=1e-14)
            self.assertAlmostEqual(np.linalg.det(camera.axes()), 1.0)

    def test_what_faces_away_is_not_drawn(self):
        turned = square(0, RED)
        turned.corners = turned.corners[:, ::-1]
        self.assertTrue(np.all(render.picture(CAMERA, turned) == 1.0))

    def test_a_sphere_covers_its_disc(self):
        camera = render.Camera((0, 0, 1), (0, 1, 0), (0, 0, 0), 2.5, (200, 200))
        _, depth = render.lit(camera, sphere(60))
        found = np.isfinite(depth).sum() * (2.5 / 400) ** 2
        self.assertAlmostEqual(found / np.pi, 1.0, delta=4e-3)
        self.assertAlmostEqual(-depth.min() * 2.5 / 400, 1.0, delta=1e-3)

    def test_light_runs_on_over_a_sphere_and_stops_at_a_crease(self):
        ball = sphere(40)
        solid = np.linalg.norm(np.cross(ball.corners[:, 1] - ball.corners[:, 0],
                                        ball.corners[:, 2] - ball.corners[:, 0]), axis=1) > 1e-9  # not those at the poles
        outward = np.einsum("ijk,ijk->ij", ball.normals, ball.corners)[solid]
        self.assertGreater(outward.min(), 0.999)
        p = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 1.0]])
        folded = render.smooth_normals(p[[[0, 1, 2], [0, 3, 1]]], np.array([0, 0]))
        np.testing.assert_allclose(folded[0], np.tile([0, 0, 1], (3, 1)), atol=1e-12)

    def test_one_sees_through_a_ghost(self):
        image = render.picture(CAMERA, square(-0.2, RED), [square(0.2, BLUE, 0.8)], opacity=0.3)
        self.assertTrue(is_red(image[50, 50]))
        self.assertGreater(image[50, 50, 2], 0.1)
        self.assertGreater(image[14, 14, 2], image[14, 14, 0])

    def test_the_same_triangles_give_the_same_picture(self):
        self.assertTrue(np.array_equal(render.picture(CAMERA, sphere(20)), render.picture(CAMERA, sphere(20))))


if __name__ == "__main__":
    unittest.main()
