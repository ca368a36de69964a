"""STEP files where Open CASCADE is there, and what is said where it is not."""
import glob
import os
import shutil
import subprocess
import tempfile
import unittest

from lamina_command import LAMINA

EMPTY = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('part','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1 = CARTESIAN_POINT('',(0.,0.,0.));
ENDSEC;
END-ISO-10303-21;
"""


def libraries():
    """Where the command finds the core."""
    listed = subprocess.run(["ldd", LAMINA], stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout
    core = next(line.split("=>")[1].split("(")[0].strip() for line in listed.splitlines() if "liblamina_core" in line)
    return os.path.dirname(core)


WITH_STEP = glob.glob(os.path.join(libraries(), "liblamina_step.so"))


class StepFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("part.step")
        with open(self.part, "w", encoding="utf-8") as file:
            file.write(EMPTY)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def refusal(self, **environment):
        done = subprocess.run([LAMINA, "slice", self.part, "-o", self.path("part.gcode")], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, check=False,
                              env={**os.environ, **environment})
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stdout, "")
        self.assertFalse(os.path.exists(self.path("part.gcode")))
        return done.stderr

    def test_what_is_missing_is_named(self):
        shutil.copy(os.path.join(libraries(), "liblamina_core.so"), self.folder.name)
        said = self.refusal(LD_LIBRARY_PATH=self.folder.name)
        self.assertIn(self.part, said)
        self.assertIn("install libocct-data-exchange-dev", said)

    @unittest.skipUnless(WITH_STEP, "built without Open CASCADE")
    def test_a_file_without_solids_is_refused(self):
        self.assertIn("no solid", self.refusal())


if __name__ == "__main__":
    unittest.main()
