# Run in a case folder with times 0, 0.08, 0.16 and what pfemProbe has sampled. See the script `module`.

import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
import pfem

PLACES = [[0.5, 0.3], [0.05, 0.1], [0.297, 0.05]]


def history(*arguments):
    text = subprocess.run(["pfemHistory", *arguments], check=True, capture_output=True, text=True).stdout
    return np.array([[float(word) for word in line.split()] for line in text.splitlines()])


class Module(unittest.TestCase):
    case = pfem.Case()

    def testTimes(self):
        self.assertEqual(self.case.times, ["0", "0.08", "0.16"])
        self.assertEqual(self.case.read(0.09).name, "0.08")
        self.assertEqual(self.case.read("latest").time, 0.16)
        with self.assertRaisesRegex(FileNotFoundError, "no time '0.5'.*0.08"):
            self.case.read("0.5")

    def testFieldsArePfemProbes(self):
        order = [0, 3, 5, 1, 4, 2]  # OpenFOAM's xx xy xz yy yz zz from VTK's XX YY ZZ XY YZ XZ
        for field in ("U", "p", "D", "sigma"):
            probed = self.case.table("probes", field)
            for k, name in enumerate(self.case.times):
                values = self.case.read(name).sample(PLACES, field)
                values = values[:, order] if field == "sigma" else values
                np.testing.assert_allclose(values, probed.values[k], rtol=2e-5, atol=1e-9, err_msg=f"{field} at {name}")
        self.assertTrue(np.isnan(probed.values[:, 0]).all())     # dry
        self.assertTrue((probed.values[1:, 2, 1] != 0).any())    # in the wall

    def testTablesArePfemHistorys(self):
        tip = self.case.table("tip", "D")
        text = history("tip", "D")
        np.testing.assert_array_equal(tip.time, text[:, 0])
        np.testing.assert_array_equal(tip.values[:, 0], text[:, 1:])
        np.testing.assert_allclose(tip.points, [[0.292, 0.08, 0]])
        mass = self.case.table("mass", "fluidVolume.dat")
        np.testing.assert_array_equal(mass["relativeChange"], history("-columns", "relativeChange", "mass", "fluidVolume.dat")[:, 0])
        self.assertEqual(mass.get("never").sum(), 0)
        with self.assertRaisesRegex(KeyError, "relativeChange"):
            mass["never"]

    def testAreaIsTheLedgersVolume(self):
        mass = self.case.table("mass", "fluidVolume.dat")
        for step in self.case.steps(0.005):
            k = np.argmin(abs(mass.time - step.time))
            volume = pfem.cellAreas(step.fluid).sum() + step.fluid.point["dropVolume"].sum()
            self.assertAlmostEqual(volume / mass["volume"][k], 1, delta=1e-5)

    def testWords(self):
        step = self.case.read("0")
        self.assertEqual(list(step.solid.field["materials"]), list(step.fluid.field["materials"]))
        self.assertIn("rubber", step.solid.field["materials"])
        self.assertIn("tank", step.boundary.field["patchNames"])
        self.assertTrue((step.solid.cellsOf("material") == step.solid.field["materials"].index("rubber")).all())

    def testTrace(self):
        step = self.case.read("0.08")
        ids = step.fluid.point["id"][[5, 50]]
        time, paths = self.case.trace(np.append(ids, 10 ** 9))
        np.testing.assert_array_equal(time, [0, 0.08, 0.16])
        np.testing.assert_array_equal(paths[1, :2], step.fluid.points[[5, 50]])
        self.assertTrue(np.isnan(paths[:, 2]).all())

    def testDerived(self):
        grid = self.case.read("0").fluid
        x, y = grid.points[:, 0], grid.points[:, 1]
        grid.point["W"] = np.stack([-2 * y, 3 * x, 0 * x], axis=1)
        np.testing.assert_allclose(pfem.vorticity(grid, "W"), 5, rtol=1e-9)
        np.testing.assert_allclose(pfem.gradient(grid, 4 * x - y), np.broadcast_to([4, -1], (len(x), 2)), atol=1e-9)
        self.assertAlmostEqual(pfem.vonMises([3.0, 0, 0, 0, 0, 0]), 3)
        self.assertAlmostEqual(pfem.vonMises([0.0, 0, 0, 2, 0, 0]), 2 * 3 ** 0.5)
        self.assertAlmostEqual(pfem.vonMises([5.0, 5, 5, 0, 0, 0]), 0)

    def testJoin(self):
        step = self.case.read("0.16")
        both = pfem.join(step.fluid, step.solid)
        shared = np.intersect1d(step.fluid.point["id"], step.solid.point["id"])
        self.assertGreater(len(shared), 0)
        self.assertEqual(len(both.points), len(step.fluid.points) + len(step.solid.points) - len(shared))
        self.assertAlmostEqual(pfem.cellAreas(both).sum(), pfem.cellAreas(step.fluid).sum() + pfem.cellAreas(step.solid).sum())
        at = both.index(step.solid.point["id"])
        np.testing.assert_array_equal(both.point["vonMises"][at], pfem.vonMises(step.solid.point["sigma"]))
        at = both.index(step.fluid.point["id"])
        for name in ("U", "p", "D"):
            np.testing.assert_array_equal(both.point[name][at], step.fluid.point[name])
        np.testing.assert_array_equal(both.point["vorticity"][at], pfem.vorticity(step.fluid))
        self.assertEqual(both.cell["part"].sum(), len(step.solid.triangles))

    def testDamagedFilesAreErrors(self):
        data = pathlib.Path("0.08/fluid.vtu").read_bytes()
        at = data.index(b"_", data.index(b"<AppendedData"))
        for damaged in (b"", b"<VTKFile", data[:at], data[:-3000], data.replace(b"vtkZLib", b"vtkLZ4B"),
                        data[:at + 1] + b"\xff" * 8 + data[at + 9:]):
            with tempfile.NamedTemporaryFile() as file:
                pathlib.Path(file.name).write_bytes(damaged)
                with self.assertRaisesRegex(ValueError, file.name):
                    pfem.readVtu(file.name)

    def testTablesOfManyForms(self):
        with tempfile.TemporaryDirectory() as folder:
            first, second = pathlib.Path(folder, "a"), pathlib.Path(folder, "b")
            first.write_text("# Text\n#  Time  volume  c\n 0.1 5 -1e+300\n 0.2 6 7\n 0.3 1 1\n")
            second.write_text("# Text\n#  Time  volume  c\n 0.25 8 9\n 0.3 1")
            table = pfem.readTable(first, second)
            np.testing.assert_array_equal(table.time, [0.1, 0.2, 0.25])
            np.testing.assert_array_equal(table["volume"], [5, 6, 8])
            self.assertTrue(np.isnan(table["c"][0]))
            first.write_text("# Time\tfield\tmin\tlocation(min)\n0.1\tp\t3\t(1 2 0)\n0.1\tU\t4\t(1 3 0)\n")
            table = pfem.readTable(first)
            self.assertEqual(list(table["field"]), ["p", "U"])
            self.assertEqual(table["location(min)"][1, 1], 3)
            first.write_text("# Time v\n 0.1 5 6\n 0.2 5\n")
            with self.assertRaisesRegex(ValueError, "a row has 2 columns"):
                pfem.readTable(first)

    def testOtherFrames(self):
        grid = self.case.read("0.08").fluid
        for needed, check in (("pandas", lambda: self.assertIn("U_x", grid.frame().columns)),
                              ("meshio", lambda: self.assertEqual(len(grid.toMeshio().points), len(grid.points))),
                              ("vtkmodules", lambda: self.assertEqual(grid.toVtk().GetNumberOfCells(), len(grid.types)))):
            try:
                __import__(needed)
            except ImportError:
                continue
            with self.subTest(needed):
                check()


if __name__ == "__main__":
    unittest.main()
