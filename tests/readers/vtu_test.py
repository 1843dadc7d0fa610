"""vtu_test.py SETTLE_FEM CASE SCRATCH: the VTU and PVD files of a small-strain column of Q2 elements, read by
meshio, against the result file, read by h5py. VTU files hold single precision: 24 bits, 6e-8 of a number.
"""
import pathlib
import shutil
import subprocess
import sys
import tomllib
import unittest
import xml.etree.ElementTree

try:
    import h5py
    import meshio
    import numpy
except ImportError as missing:
    print(f"skipped: {missing} (Debian: python3-h5py, python3-meshio)")
    sys.exit(77)

solver, case, scratch = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
single_precision = 2.0**-24
stress_names = ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_xz"]


def run():
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    subprocess.run([solver, case, "--quiet", "--out", scratch / "fem.h5", "--vtu", scratch], check=True)


def stage_files():
    """By time step, as the PVD lists them."""
    sets = xml.etree.ElementTree.parse(scratch / "stages.pvd").getroot().iter("DataSet")
    return {int(each.get("timestep")): scratch / each.get("file") for each in sets}


class VtuFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run()
        cls.study = tomllib.loads(case.read_text())
        cls.result = h5py.File(scratch / "fem.h5")
        cls.meshes = {step: meshio.read(file) for step, file in stage_files().items()}

    def assert_close(self, value, wanted, scale, message):
        self.assertLessEqual(numpy.max(numpy.abs(value - wanted)), 2 * single_precision * scale, message)

    def test_there_is_a_file_for_every_stage(self):
        self.assertEqual(list(self.meshes), [int(name) for name in self.result["stages"]])

    def test_the_cells_are_those_that_have_been_placed(self):
        height, width, size = (self.study["geometry"]["height"], self.study["geometry"]["width"],
                               self.study["fem"]["element_size"])
        for step, mesh in self.meshes.items():
            placed = height * step / self.study["construction"]["layers"]
            pieces = 4  # a quadratic cell is drawn as four
            self.assertEqual(len(mesh.cells_dict["quad"]), pieces * round(placed / size) * round(width / size))
            self.assertAlmostEqual(mesh.points[:, 1].max(), placed, delta=single_precision * height)

    def test_displacements_are_those_of_the_probes(self):
        for step, mesh in self.meshes.items():
            probes = self.result[f"stages/{step:04}/probes/axis"]
            largest = numpy.abs(probes["displacement"]).max()
            for layer, position, displacement in zip(probes["layer"], probes["design_position"], probes["displacement"]):
                near = numpy.linalg.norm(mesh.points[:, :2] - position, axis=1) < 1e-6 * self.study["geometry"]["height"]
                nodes = near & (mesh.point_data["layer"] == layer)
                self.assertGreaterEqual(nodes.sum(), 1, f"no node at {position} in layer {layer}")
                self.assert_close(mesh.point_data["displacement"][nodes][:, :2], displacement, largest, position)

    def test_stresses_are_those_in_the_middle_of_each_cell(self):
        size = self.study["fem"]["element_size"]
        for step, mesh in self.meshes.items():
            points = self.result[f"stages/{step:04}/points"]
            row = numpy.floor(points["placed_position"][:, 1] / size)
            for number in numpy.unique(row):
                mine = row == number
                mean = numpy.average(points["stress"][mine], axis=0, weights=points["volume"][mine])  # stress is linear
                middle = numpy.abs(mesh.points[:, 1] / size - (number + 0.5)) < 0.25
                self.assertTrue(middle.any(), f"no node in the middle of row {number}")
                for component, name in enumerate(stress_names):
                    self.assert_close(mesh.point_data[name][middle], mean[component], numpy.abs(points["stress"]).max(),
                                      f"{name} in row {number}")


unittest.main(argv=sys.argv[:1])
