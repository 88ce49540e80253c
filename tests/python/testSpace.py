# Run in a folder with the time 0 of a case in space: a box of water, 0.4 x 0.3 x 0.4 m, and a solid.

import unittest

import numpy as np
import pfem


class Space(unittest.TestCase):
    step = pfem.Case().read("0")

    def testVolume(self):
        self.assertAlmostEqual(pfem.cellVolumes(self.step.fluid).sum(), 0.048)
        self.assertEqual(len(self.step.fluid.cellsOf("material")), len(self.step.fluid.tetrahedra))

    def testLinearFieldsAreExact(self):
        grid = self.step.fluid
        x, y, z = grid.points.T
        grid.point["W"] = np.stack([2 * z - 3 * y, 4 * x, y], axis=1)
        np.testing.assert_allclose(pfem.vorticity(grid, "W"), np.broadcast_to([1, 2, 7], (len(x), 3)), atol=1e-9)
        np.testing.assert_allclose(pfem.gradient(grid, 4 * x - y + 2 * z), np.broadcast_to([4, -1, 2], (len(x), 3)), atol=1e-9)
        places = np.array([[0.1, 0.1, 0.1], [0.39, 0.01, 0.33], [0.5, 0.1, 0.1]])
        sampled = grid.sample(places, "W")
        np.testing.assert_allclose(sampled[:2, 0], 2 * places[:2, 2] - 3 * places[:2, 1], atol=1e-9)
        self.assertTrue(np.isnan(sampled[2]).all())  # dry

    def testJoin(self):
        both = pfem.join(self.step.fluid, self.step.solid)
        self.assertEqual(both.point["vorticity"].shape, (len(both.points), 3))
        self.assertEqual(both.cell["part"].sum(), len(self.step.solid.tetrahedra))
        both.point["W"] = both.points[:, [1, 0, 2]] * [-1, 1, 1]
        at = both.index(self.step.solid.point["id"])
        np.testing.assert_allclose(pfem.vorticity(both, "W")[at], np.broadcast_to([0, 0, 2], (len(at), 3)), atol=1e-9)


unittest.main()
