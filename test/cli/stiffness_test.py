"""Runs `lamina stiffness` as a person would, and CalculiX on the decks that it writes."""
import os
import shutil
import subprocess
import tempfile
import unittest

from lamina_command import lamina, reported


def reaction_of(folder, name):
    """Total force that CalculiX finds in the deck NAME.inp [N], by axis."""
    subprocess.run(["ccx", name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, name + ".dat"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    at = next(i for i, line in enumerate(lines) if "total force" in line)
    return [float(word) for word in next(line for line in lines[at + 1:] if line.split()).split()]


class Stiffness(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_a_solid_box_has_the_modulus_of_its_material(self):
        for axis in "xyz":
            found = reported("stiffness", "box", "--voxel-mm", "2", "--axis", axis)
            self.assertAlmostEqual(found["modulus_mpa"] / 3861.0, 1.0, delta=1e-4)
            self.assertLessEqual(found["residual"], 1e-6)
            self.assertEqual(found["dropped"], [])

    def test_strands_thinner_than_four_voxels_are_reported(self):
        reported("scaffold", "sinusoidal", "--set", "scaffold.height_mm=1.5", "-o", self.path("cube.csv"))
        coarse = reported("stiffness", self.path("cube.csv"), "--voxel-mm", "0.15")
        self.assertLess(coarse["strand_voxels"], 4)
        self.assertGreater(coarse["thin_percent"], 10.0)
        solid = reported("stiffness", "box", "--voxel-mm", "2")
        self.assertEqual((solid["strand_voxels"], solid["thin_percent"]), (4, 0.0))

    def test_a_printed_scaffold_is_softer_than_its_material_and_has_fields_to_look_at(self):
        reported("scaffold", "sinusoidal", "--set", "scaffold.height_mm=3", "-o", self.path("cube.csv"))
        found = reported("stiffness", self.path("cube.csv"), "--voxel-mm", "0.1", "-o", self.path("cube.vtk"))
        self.assertGreater(found["modulus_mpa"], 1.0)
        self.assertLess(found["modulus_mpa"], 0.5 * 3861.0)
        with open(self.path("cube.vtk"), "rb") as file:
            head = file.read(200)
        self.assertTrue(head.startswith(b"# vtk DataFile"))
        self.assertIn(b"UNSTRUCTURED_GRID", head)

    @unittest.skipUnless(shutil.which("ccx"), "calculix-ccx is not installed")
    def test_calculix_finds_the_same_forces_in_the_same_elements(self):
        reported("scaffold", "sinusoidal", "--set", "scaffold.height_mm=1.5", "-o", self.path("cube.csv"))
        for name, load in (("pressed", "compression"), ("bent", "bending")):
            source = self.path("cube.csv") if load == "compression" else "box"
            voxel = "0.15" if load == "compression" else "2"
            span = [] if load == "compression" else ["--set", "stiffness.span_mm=12"]
            found = reported("stiffness", source, "--voxel-mm", voxel, "--load", load, *span, "--set",
                         "stiffness.residual=1e-9", "--deck", self.path(name + ".inp"))
            axis = "xyz".index(found["load"]["axis"])
            theirs = abs(reaction_of(self.folder.name, name)[axis])
            self.assertAlmostEqual(abs(found["force_n"]) / theirs, 1.0, delta=1e-5)

    def test_what_cannot_be_solved_is_refused_before_anything_is_written(self):
        for arguments in (["--set", "stiffness.poissons_ratio=0.5"], ["--voxel-mm", "0.0001"],
                          ["--load", "bending", "--set", "stiffness.span_mm=1000"]):
            done = lamina("stiffness", "box", *arguments, "-o", self.path("no.vtk"))
            self.assertNotEqual(done.returncode, 0)
            self.assertNotEqual(done.stderr, "")
            self.assertFalse(os.path.exists(self.path("no.vtk")))


if __name__ == "__main__":
    unittest.main()
