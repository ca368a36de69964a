#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs corrected by maps, as files and on their way to the emulated machine, which is left in mid job.

    corrections_test.py LAMINA
"""
import math
import os
import random
import re
import signal
import struct
import subprocess
import tempfile
import time
import unittest

from lamina_command import LAMINA, lamina, reported

LAYERS = 60
SEGMENTS = 20  # of the bead of each layer
LENGTH_MM = 40.0
STATIONS = 40
FILAMENT_PER_MM = 0.05
KILLS = 5
PATIENCE_S = 120
ID = "00112233aabbccdd"
HEADER = "layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s"


def digest(toolpath, layer, path, station_mm, stations):
    """FNV-1a over 64-bit words, as the page on the closed loop says."""
    value = 0xCBF29CE484222325
    words = [len(toolpath), *toolpath.encode(), layer, 1, 1, path, struct.unpack("<Q", struct.pack("<d", station_mm))[0], len(stations)]
    for place in stations:
        words += [struct.unpack("<Q", struct.pack("<d", number))[0] for number in place]
    for word in words:
        value = (value ^ word) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
        value ^= value >> 29
    return f"{value:016x}"


def correction_map(layer, amounts, toolpath=ID, length_mm=LENGTH_MM, path=1):
    """A map of the bead of a layer, its path 1 unless the way to it is part of the wait before."""
    station_mm = length_mm / len(amounts)
    stations = [(amount, 0.0, 0.0) for amount in amounts]
    rows = "".join(f"{path},{station_mm!r},{amount!r},0,0\n" for amount in amounts)
    return (f"# toolpath {toolpath}\n# layer {layer}\n# sequence 1\n# digest {digest(toolpath, layer, path, station_mm, stations)}\n"
            f"path,station_mm,amount,speed,dz_mm\n{rows}")


def amounts_of(layer):
    return [0.2 * math.sin(0.3 * i + layer) for i in range(STATIONS)]


def filament_of(amounts):
    """Amounts are linear between the middles of equal pieces, and even beyond the first and the last."""
    return FILAMENT_PER_MM * LENGTH_MM * (1.0 + sum(amounts) / len(amounts))


class Corrections(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program, self.port, self.record, self.journal = map(self.path, ("part.gcode", "port", "record", "job.progress"))
        self.maps, self.corrected = self.path("maps"), self.path("corrected.gcode")
        os.mkdir(self.maps)
        self.write_part()
        for layer in range(1, LAYERS):
            self.write(f"maps/correction_{layer}.csv", correction_map(layer, amounts_of(layer)))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, path):
        with open(path, encoding="utf-8") as file:
            return file.read()

    def write_part(self):
        """A wall, there and back, as a program and as the toolpath that it is of."""
        lines, rows, x = ["G90", "M83"], [f"#TOOLPATH: {ID}", HEADER], 0.0
        for layer in range(LAYERS):
            z, step = 0.5 * (layer + 1), LENGTH_MM / SEGMENTS * (-1.0 if layer % 2 else 1.0)
            lines += [f";LAYER:{layer}", f"G1 X{x:g} Y10 Z{z:g} F3000"]
            rows += [f"{layer},0,travel,0,{x:g},10,{height:g},0,1,0,0,0,0,50" for height in (max(z - 0.5, 0.5), z)]
            rows.append(f"{layer},1,outer_wall,0,{x:g},10,{z:g},0,1,0,0,1,0.5,50")
            for _ in range(SEGMENTS):
                x += step
                lines.append(f"G1 X{x:g} Y10 E{FILAMENT_PER_MM * abs(step):g} F3000")
                rows.append(f"{layer},1,outer_wall,0,{x:g},10,{z:g},0,1,0,0,1,0.5,50")
        self.write("part.gcode", "\n".join(lines) + "\n")
        self.write("maps/toolpath.csv", "\n".join(rows) + "\n")

    @staticmethod
    def filament_by_layer(program):
        """Of the motions of a program, by the layer they are of."""
        by_layer, layer = {}, -1
        for line in program.splitlines():
            if line.startswith(";LAYER:"):
                layer = int(line[7:])
            for word in re.findall(r"^G1 .*E([-.\d]+)", line):
                by_layer[layer] = by_layer.get(layer, 0.0) + float(word)
        return by_layer

    def expect_refusal(self, *arguments, says):
        done = lamina(*arguments)
        self.assertEqual(done.returncode, 1, done.stdout)
        for word in says:
            self.assertIn(word, done.stderr)

    def test_each_layer_gets_the_filament_of_its_map(self):
        made = reported("correct", self.program, self.maps, "-o", self.corrected)
        self.assertEqual(len(made["maps"]), LAYERS - 1)
        self.assertEqual((made["toolpath_id"], made["off_path_lines"]), (ID, 0))
        self.assertGreater(made["added_lines"], 0)
        by_layer = self.filament_by_layer(self.read(self.corrected))
        self.assertAlmostEqual(by_layer[0], FILAMENT_PER_MM * LENGTH_MM, delta=1e-9)
        for layer in range(1, LAYERS):
            self.assertAlmostEqual(by_layer[layer], filament_of(amounts_of(layer)), delta=1e-4)

    def test_maps_of_nothing_change_no_byte(self):
        for layer in range(1, LAYERS):
            self.write(f"maps/correction_{layer}.csv", correction_map(layer, [0.0] * STATIONS))
        reported("correct", self.program, self.maps, "-o", self.corrected)
        self.assertEqual(self.read(self.corrected), self.read(self.program))

    def test_what_does_not_fit_is_refused_whole_by_name(self):
        correct = ("correct", self.program, self.maps, "-o", self.corrected)
        stream = ("stream", self.program, "--port", self.path("none"), "--corrections", self.maps)
        self.write("maps/correction_7.csv", correction_map(7, amounts_of(7), "another"))
        for command in (correct, stream):
            self.expect_refusal(*command, says=("correction_7.csv: the map is of toolpath another", ID))
        self.write("maps/correction_7.csv", correction_map(7, [0.5] * STATIONS).replace("0.5,0,0", "0.4,0,0", 1))
        for command in (correct, stream):
            self.expect_refusal(*command, says=("correction_7.csv", "digest"))
        os.remove(self.path("maps/correction_7.csv"))
        os.remove(self.path("maps/toolpath.csv"))
        self.expect_refusal(*correct, says=("toolpath.csv",))
        self.expect_refusal("stream", self.program, "--port", self.port, "--toolpath", self.program, says=("--corrections",))
        self.assertFalse(os.path.exists(self.corrected))

    def emulate(self, *options):
        machine = subprocess.Popen([LAMINA, "emulate", "--pty", self.port, "--speed-up", "200", "--record", self.record, *options],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(machine.wait)
        self.addCleanup(machine.kill)
        self.wait_for(lambda: os.path.exists(self.port))
        return machine

    def wait_for(self, condition):
        end = time.monotonic() + PATIENCE_S
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def options(self, *more):
        return ("--port", self.port, "--set", f"stream.journal={self.journal}", *more)

    def stream(self, *more):
        return subprocess.Popen([LAMINA, "stream", self.program, *self.options("--corrections", self.maps, *more)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def known(self):
        return reported("stream", self.program, "--progress", *self.options())

    def kill_at(self, streaming, line):
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["taken_through"] >= line)
        streaming.kill()
        streaming.communicate()

    def ran(self, machine):
        machine.send_signal(signal.SIGINT)
        machine.wait(PATIENCE_S)
        return [line for line in self.read(self.record).splitlines() if not line.startswith(";")]

    def commands_of(self, path):
        return [line for line in self.read(path).splitlines() if line and not line.startswith(";")]

    def test_a_killed_corrected_job_goes_on_where_it_was(self):
        machine = self.emulate()
        made = reported("correct", self.program, self.maps, "-o", self.corrected)
        commands = self.commands_of(self.corrected)
        streaming = self.stream()
        for line in sorted(random.Random(2).sample(range(1, int(0.8 * len(commands))), KILLS)):
            self.kill_at(streaming, line)
            known = self.known()
            self.assertEqual(known["state"], "Execute")
            self.assertEqual(known["corrected_from"]["maps"], made["maps"])
            streaming = self.stream("--resume")
        said = streaming.communicate(timeout=PATIENCE_S)[1]
        self.assertEqual(streaming.returncode, 0, said)
        self.assertEqual(self.known()["state"], "Complete")
        ran = self.ran(machine)
        self.assertEqual(ran, commands, "no line lost or repeated")
        deposited = sum(float(word) for line in ran for word in re.findall(r"^G1 .*E([-.\d]+)", line))
        commanded = FILAMENT_PER_MM * LENGTH_MM + sum(filament_of(amounts_of(layer)) for layer in range(1, LAYERS))
        self.assertAlmostEqual(deposited, commanded, delta=1e-4 * LAYERS)

    def test_a_job_goes_on_by_the_same_maps_only(self):
        machine = self.emulate()
        made = reported("correct", self.program, self.maps, "-o", self.corrected)
        self.kill_at(self.stream(), 200)
        resume = ("stream", self.program, *self.options("--resume"))
        self.expect_refusal(*resume, says=(f"was corrected by {LAYERS - 1} correction maps",))
        self.write("maps/correction_30.csv", correction_map(30, [0.1] * STATIONS))
        self.expect_refusal(*resume, "--corrections", self.maps, says=("layer 30 by map", made["maps"][29]["digest"]))
        os.remove(self.path("maps/correction_30.csv"))
        self.expect_refusal(*resume, "--corrections", self.maps, says=("layer 30 by map", made["maps"][29]["digest"]))
        self.write("maps/correction_30.csv", correction_map(30, amounts_of(30)))
        self.expect_refusal(*resume, "--corrections", self.maps, "--set", "loop.lag_s=1", says=("other settings (loop.*)",))
        self.expect_refusal("resume", self.program, *self.options(), says=("lamina correct",))
        offer = reported("resume", self.corrected, *self.options())
        self.assertEqual(offer["from_line"], self.known()["taken_through"] + 1)
        reported("stream", self.program, *self.options("--resume", "--corrections", self.maps))
        self.assertEqual(self.ran(machine), self.commands_of(self.corrected))


class RobotPrograms(unittest.TestCase):
    """RAPID as `lamina slice` writes it: the process is steady, so that an amount is deposited by its time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program, self.corrected, self.maps = (os.path.join(self.folder, name) for name in ("wall.mod", "corrected.mod", "maps"))
        os.mkdir(self.maps)
        self.part, toolpath = os.path.join(self.folder, "wall.stl"), os.path.join(self.folder, "wall.csv")
        reported("part", "flat_wall", "--set", "length_mm=20", "--set", "height_mm=1", "-o", self.part)
        for output in (self.program, toolpath):
            reported("slice", self.part, "--set", "machine.name=irb_4600", "--set", "part.placement=as_is", "-o", output)
        with open(toolpath, encoding="utf-8") as file:
            self.rows = [line.split(",") for line in file.read().splitlines()[1:]]
            file.seek(0)
            self.write("toolpath.csv", f"#TOOLPATH: {ID}\n" + file.read())

    def write(self, name, text):
        with open(os.path.join(self.maps, name), "w", encoding="utf-8") as file:
            file.write(text)

    def length_and_time(self, layer, path):
        rows = [row for row in self.rows if row[:2] == [str(layer), str(path)]]
        places = [tuple(map(float, row[4:7])) for row in rows]
        ways = [math.dist(a, b) for a, b in zip(places, places[1:])]
        return sum(ways), sum(way / float(row[13]) for way, row in zip(ways, rows[1:]))

    def test_an_amount_takes_its_time_and_reads_back(self):
        length_mm, time_s = self.length_and_time(2, 1)
        self.write("correction_2.csv", correction_map(2, [0.25] * 8, length_mm=length_mm))
        made = reported("correct", self.program, self.maps, "-o", self.corrected)
        self.assertAlmostEqual(made["corrected_s"] - made["planned_s"], 0.25 * time_s, delta=1e-3)
        self.assertEqual(lamina("preview", self.corrected, "--layer", "2", "-o", os.path.join(self.folder, "layer.png")).returncode, 0)
        self.assertNotEqual(reported("metrics", self.corrected, "--part", self.part), {})

    def test_other_languages_take_their_time_too(self):
        length_mm, time_s = self.length_and_time(2, 1)
        self.write("correction_2.csv", correction_map(2, [0.25] * 8, length_mm=length_mm))
        for suffix in ("src", "ls", "jbi"):
            program, corrected = (os.path.join(self.folder, f"{name}.{suffix}") for name in ("wall", "corrected"))
            reported("slice", self.part, "--set", "machine.name=irb_4600", "--set", "part.placement=as_is", "-o", program)
            made = reported("correct", program, self.maps, "-o", corrected)
            # Fanuc's speeds are whole numbers, Yaskawa's have one decimal.
            self.assertAlmostEqual(made["corrected_s"] - made["planned_s"], 0.25 * time_s, delta=0.02 * time_s)
            picture = os.path.join(self.folder, "layer.png")
            self.assertEqual(lamina("preview", corrected, "--layer", "2", "-o", picture).returncode, 0)

    def slice_again(self, suffix, *settings):
        program, corrected = (os.path.join(self.folder, f"{name}.{suffix}") for name in ("wall", "corrected"))
        chosen = [word for setting in settings for word in ("--set", setting)]
        reported("slice", self.part, "--set", "part.placement=as_is", *chosen, "-o", program)
        return program, corrected

    def test_arcs_are_not_written_as_outputs(self):
        length_mm, time_s = self.length_and_time(2, 1)
        self.write("correction_2.csv", correction_map(2, [0.25] * 8, length_mm=length_mm))
        arcs = ("robot_program.process=schedules", "robot_program.start_schedule=6", "robot_program.end_schedule=1", "robot_program.weave_schedule=4")
        for suffix, settings, outputs in (("ls", arcs, "'output 1'"), ("jbi", arcs, "'output 1'"),
                                          ("mod", ("rapid.process=arc", "rapid.seam_data=seam7"), "'set solicitudlaser'")):
            program, corrected = self.slice_again(suffix, "machine.name=irb_4600", *settings)
            refused = lamina("correct", program, self.maps, "-o", corrected)
            self.assertEqual(refused.returncode, 1)
            for said in ("is switched by", "seam7" if suffix == "mod" else "arc start by schedule 6", outputs):
                self.assertIn(said, refused.stderr)
            self.assertFalse(os.path.exists(corrected))
            chosen = [word for setting in settings for word in ("--set", setting)]
            made = reported("correct", program, self.maps, *chosen, "-o", corrected)
            self.assertAlmostEqual(made["corrected_s"] - made["planned_s"], 0.25 * time_s, delta=0.02 * time_s)

    def test_external_axes_are_not_dropped(self):
        length_mm, _ = self.length_and_time(2, 1)
        self.write("correction_2.csv", correction_map(2, [0.25] * 8, length_mm=length_mm))
        for suffix in ("src", "ls", "mod"):
            program, corrected = self.slice_again(suffix, "machine.name=irb_4600_turntable")
            refused = lamina("correct", program, self.maps, "-o", corrected)
            self.assertEqual(refused.returncode, 1)
            self.assertRegex(refused.stderr, "the external axes of .* are [12] |is carried by")
            self.assertFalse(os.path.exists(corrected))

    def test_waits_between_layers_stay(self):
        waiting = ("machine.name=irb_4600", "cooling.by=dwell", "cooling.least_layer_time_s=100")
        toolpath, _ = self.slice_again("csv", *waiting)
        with open(toolpath, encoding="utf-8") as file:
            text = file.read()
        self.write("toolpath.csv", f"#TOOLPATH: {ID}\n" + text)
        self.rows = [line.split(",") for line in text.splitlines()[1:]]
        length_mm, time_s = self.length_and_time(2, 0)
        self.write("correction_2.csv", correction_map(2, [0.25] * 8, length_mm=length_mm, path=0))
        program, corrected = self.slice_again("src", *waiting)
        made = reported("correct", program, self.maps, "-o", corrected)
        self.assertAlmostEqual(made["corrected_s"] - made["planned_s"], 0.25 * time_s, delta=0.02 * time_s)
        waits = []
        for path in (program, corrected):
            with open(path, encoding="utf-8") as file:
                waits.append([line for line in file.read().splitlines() if line.startswith("WAIT SEC")])
        self.assertGreater(len(waits[0]), 1)
        self.assertEqual(waits[0], waits[1])

    def test_scripts_without_joints_are_refused(self):
        self.write("correction_2.csv", correction_map(2, [0.25] * 8))
        program, corrected = (os.path.join(self.folder, f"{name}.script") for name in ("wall", "corrected"))
        reported("slice", self.part, "--set", "machine.name=irb_4600", "--set", "part.placement=as_is", "-o", program)
        refused = lamina("correct", program, self.maps, "-o", corrected)
        self.assertIn("poses in URScript are over the robot's base", refused.stderr)
        self.assertFalse(os.path.exists(corrected))

    def test_maps_of_nothing_leave_the_motions(self):
        self.write("correction_2.csv", correction_map(2, [0.0] * 8))
        made = reported("correct", self.program, self.maps, "-o", self.corrected)
        self.assertEqual(made["corrected_s"], made["planned_s"])
        moves = []
        for path in (self.program, self.corrected):
            with open(path, encoding="utf-8") as program:
                depositing = program.read().partition("PROC deposit_1()")[2]
            moves.append([line.strip() for line in depositing.splitlines() if "Move" in line])
        self.assertGreater(len(moves[0]), 10)
        self.assertEqual(moves[0], moves[1])

    def test_another_program_is_refused(self):
        self.write("correction_2.csv", correction_map(2, [0.25] * 8))
        reported("correct", self.program, self.maps, "-o", self.corrected)
        again = lamina("correct", self.corrected, self.maps, "-o", self.program)
        self.assertEqual(again.returncode, 1)
        self.assertIn("layer 2, path 1 is of role", again.stderr)
        other = lamina("correct", self.program, self.maps, "-o", os.path.join(self.folder, "corrected.gcode"))
        self.assertIn("with the suffix .mod", other.stderr)


if __name__ == "__main__":
    unittest.main()
