"""Whoever has `lamina` read a file need not be allowed to read it: no message quotes a file that is not of the kind expected."""
import os
import re
import tempfile
import unittest

from lamina_command import lamina, reported

SECRET = "SECRETSECRET"
FOREIGN = {
    "shadow": "root:$6$SECRETSECRET:19000:0:99999:7:::\ndaemon:*:19000:0:99999:7:::\n",
    "words": "SECRETSECRET SECRETSECRET 1 2\nSECRETSECRET\n",
    "cells": "SECRETSECRET,aSECRETSECRET\nb,SECRETSECRET\n",
    "same cells": "SECRETSECRET,SECRETSECRET\n",
    "map": "SECRETSECRET: SECRETSECRET\npassword: SECRETSECRET\n",
    "map of lists": "SECRETSECRET: [1, 2]\n",
    "keys twice": "SECRETSECRET: 1\nSECRETSECRET: 2\n",
    "list": "- SECRETSECRET\n- a: SECRETSECRET\n",
    "json": '{"password": "SECRETSECRET", "SECRETSECRET": 1}\n',
    "broken json": '{"password": "SECRETSECRET",, SECRETSECRET \n',
    "xml": '<?xml version="1.0"?>\n<SECRETSECRET name="SECRETSECRET">SECRETSECRET</SECRETSECRET>\n',
    "broken xml": '<a SECRETSECRET="SECRETSECRET><SECRETSECRET>',
    "key": "-----BEGIN OPENSSH PRIVATE KEY-----\nSECRETSECRET\n",
    "ini": "[wifi]\npsk=SECRETSECRET\n",
    "assignment": "# SECRETSECRET\nSECRETSECRET=1\n",
    "remarks": "; SECRETSECRET\n;SECRETSECRET=1\nSECRETSECRET\n",
    "letter g": "GSECRETSECRET\nG1SECRETSECRET\n",
    "letter m": "M4 SECRETSECRET M117 SECRETSECRET\n#SECRETSECRET\n",
    "vertex": "1 SECRETSECRET 2\nv SECRETSECRET\n",
    "bytes": "\x01\x02SECRETSECRET\x00SECRETSECRET\n",
    "percent": "%SECRETSECRET\n%%%\nSECRETSECRET()\n",
}
PROGRAM, MODULE, TABLE, MESH, YAML, URDF = ".gcode", ".mod", ".csv", ".stl", ".yaml", ".urdf"
ROBOTS = (".src", ".script", ".ls", ".jbi")
ANY = ("", PROGRAM, MODULE, *ROBOTS, TABLE, MESH)
# A command, and the suffixes that lead it to its readers. FILE is the foreign file, OWN a program.
CALLS = [
    *((command + " FILE", ANY) for command in ("check", "preview")),
    *((command + " FILE", ("", PROGRAM)) for command in ("coordinates", "deposit", "overhang", "pores", "stiffness", "sweep")),
    ("audit FILE", ANY),
    ("record FILE 1", ANY),
    ("expand FILE -o OUT.urdf", ("", ".xacro")),
    ("robot FILE", ("", YAML, URDF)),
    ("info FILE", ("", MESH, ".obj", ".ply", ".3mf")),
    ("slice FILE", ("", MESH, ".obj", ".ply", ".3mf", ".svg")),
    ("slice FILE box", ("", MESH, ".svg")),
    ("slice --plate FILE", ("", YAML)),
    ("slice box --machine FILE", (YAML, URDF)),
    ("slice box --material FILE", (YAML,)),
    ("slice box --like FILE", ("", PROGRAM)),
    ("slice box --set part.modifiers=FILE", ("", YAML)),
    ("slice box --set slicing.heights=file --set slicing.heights_file=FILE", ("", TABLE)),
    ("slice box --set slicing.mode=volumetric --set volumetric.target=given --set volumetric.target_file=FILE", ("", TABLE)),
    ("film FILE -o OUT", ANY),
    ("heights FILE", ("", MESH)),
    ("lay FILE", ("", MESH)),
    ("compare FILE", ("", MESH)),
    ("replan FILE OWN -o OUT.csv", ("", PROGRAM, MODULE, TABLE)),
    ("replan OWN FILE -o OUT.csv", ("", TABLE)),
    ("rotate FILE -o OUT.stl", ("", MESH)),
    ("metrics FILE --part box", (PROGRAM, MODULE)),
    ("metrics OWN --part FILE", (MESH,)),
    ("fill-voids FILE -o OUT.gcode --part box", ("", PROGRAM)),
    ("fill-voids OWN -o OUT.gcode --part FILE", (MESH,)),
    ("voids FILE --part box", (PROGRAM, MODULE)),
    ("overhang OWN --before FILE", (PROGRAM, TABLE)),
    ("incline FILE -o OUT.gcode", ("", PROGRAM)),
    ("incline OWN -o OUT.gcode --begin-code FILE", (PROGRAM,)),
    ("incline OWN -o OUT.gcode --end-code FILE", (PROGRAM,)),
    ("stream FILE --port none", ("", PROGRAM)),
    ("stream FILE --port none --set stream.firmware=marlin", ("", PROGRAM)),
    ("correct OWN FILE -o OUT.gcode", ("", TABLE)),
    ("correct FILE FILE -o OUT.gcode --toolpath FILE", (TABLE,)),
    ("resume FILE --from-line 2 --nozzle-height 1 -o OUT.gcode", ("", PROGRAM)),
    ("calibrate sensor FILE --method pairs", ("", TABLE)),
    ("calibrate sensor OWN --method pairs -o FILE", (YAML,)),
    ("calibrate time FILE", (".bag",)),
    ("calibrate time OWN --config FILE", (YAML,)),
    ("track FILE", (TABLE,)),
    ("track OWN --urdf FILE", (URDF,)),
    ("statistics FILE --response a --factors b", ("", TABLE)),
    ("decide FILE", ("", TABLE)),
    ("optimise FILE -o OUT", ("", YAML)),
    ("estimate FILE", ("", ".bag")),
    ("estimate --print-config --config FILE", ("", YAML)),
    ("slice box --config FILE", ("", YAML)),
    ("scaffold box -o OUT.csv --config FILE", ("", YAML)),
    ("incline OWN -o OUT.gcode --config FILE", ("", YAML)),
    ("slice box --set machine.urdf=FILE", ("", URDF)),
    ("slice box --set slicing.mode=conformal --set slicing.base=FILE", (MESH,)),
    ("slice box --plugin FILE", ("",)),
]
READS_NO_FILE = {"alarms", "token", "emulate", "part", "profiles"}


class ForeignFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        reported("slice", "box", "-o", self.path("own.gcode"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="latin1") as file:
            file.write(text)
        return self.path(name)

    def call(self, command, file):
        names = {"FILE": file, "OWN": self.path("own.gcode"), "OUT": self.path("out")}
        words = [re.sub("FILE|OWN|OUT", lambda found: names[found.group()], word) for word in command.split()]
        done = lamina(*words)
        return done, done.stdout + done.stderr

    def test_no_message_quotes_one(self):
        for kind, text in FOREIGN.items():
            for command, suffixes in CALLS:
                for suffix in suffixes:
                    done, output = self.call(command, self.write("foreign" + suffix, text))
                    self.assertNotIn(SECRET, output, f"{kind}: {command}, {suffix}")
                    self.assertGreaterEqual(done.returncode, 0, f"{kind}: {command}, {suffix}")

    def test_no_command_waits_for_a_pipe_or_reads_a_device_without_end(self):
        for command, suffixes in CALLS:
            for suffix in suffixes:
                pipe, device = self.path("pipe" + suffix), self.path("device" + suffix)
                for path, make in ((pipe, os.mkfifo), (device, lambda name: os.symlink("/dev/zero", name))):
                    if not os.path.lexists(path):
                        make(path)
                    done, output = self.call(command, path)
                    self.assertNotEqual(done.returncode, 0, f"{command}, {suffix}: {output}")

    def test_every_command_that_reads_a_file_is_tried(self):
        tried = {command.split()[0] for command, _ in CALLS} | READS_NO_FILE
        listed = lamina("--help").stdout.split("Subcommands:")[1]
        self.assertEqual({line.split()[0].rstrip(",") for line in listed.splitlines() if re.match(r"  \w", line)} - tried, set())

    def test_a_name_that_is_nearly_right_is_suggested(self):
        for command, nearest in (("slcie box", "'slice'"), ("slice sfere", "'sphere'"), ("slice boxx", "'box'")):
            done = lamina(*command.split())
            self.assertIn("did you mean " + nearest, done.stderr)
            self.assertNotEqual(done.returncode, 0)

    def test_a_file_of_the_kind_expected_is_quoted(self):
        cases = [("stream FILE --port none --set stream.firmware=marlin", "a.gcode", "G28\nG1 X1 *5\n", "'G1 X1 *5'"),
                 ("incline FILE -o OUT.gcode", "a.gcode", "G28\nG1 X1 #5\n", "'#5'"),
                 ("preview FILE -o OUT.png", "a.gcode", "G28\nG1 X1.2.3\n", "'.3'"),
                 ("preview FILE -o OUT.png", "a.mod", "MODULE a\nPROC main()\n%surprise\n", "'surprise'"),
                 ("preview FILE -o OUT.png", "a.src", "DEF a()\nsurprise\n", "'surprise'"),
                 ("preview FILE -o OUT.png", "a.script", "def a():\nsurprise(1)\n", "'surprise'"),
                 ("preview FILE -o OUT.png", "A.ls", "/PROG  A\n/MN\n   1:surprise ;\n/POS\n/END\n", "'surprise ;'"),
                 ("preview FILE -o OUT.png", "A.jbi", "/JOB\n//POS\n//INST\nNOP\nsurprise\n", "'surprise'"),
                 ("info FILE", "a.obj", "v 0 0 0\nv 1 a 0\n", "'a'"),
                 ("statistics FILE --response a --factors b", "a.csv", "height,time\n1,2\n", "height, time"),
                 ("slice box --config FILE", "a.yaml", "infill:\n  density: 0.1\n  densty: 0.2\n", "'infill.densty'"),
                 ("slice box --config FILE", "b.yaml", "infill:\n  densty: 0.2\n", "did you mean 'infill.density'"),
                 ("optimise FILE -o OUT", "a.yaml", "name: a\nvaribles: {}\n", "'varibles'")]
        for command, name, text, quoted in cases:
            _, output = self.call(command, self.write(name, text))
            self.assertIn(quoted, output, command)


if __name__ == "__main__":
    unittest.main()
