#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checksums of what the command writes, over parts, strategies, modes and machines: a change of structure changes no byte.

    golden_programs.py LAMINA [--write] [--models FOLDER --list FILE]

LAMINA    the command to test
--write   replaces the list instead of comparing with it
--models  meshes of a folder instead of the parametric parts; their list is FILE
"""
import argparse
import concurrent.futures
import hashlib
import pathlib
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("golden_programs.sha256")
STRATEGIES = ["zigzag", "contour", "spiral", "hilbert", "hilbert_quadtree", "hybrid", "perimeters"]
PATTERNS = ["grid", "triangles", "cubic", "honeycomb", "gyroid"]
DROPS = ["drops_contour", "drops_dense", "drops_raster"]
PLAIN = {"skins.top_layers": "0", "skins.bottom_layers": "0", "bridges.use": "false", "overhangs.use": "false",
         "cooling.least_layer_time_s": "0", "fan.use": "false"}
COARSE = {"slicing.layer_height_mm": "0.5", "slicing.first_layer_height_mm": "0.5", **PLAIN}
PLATE = {"part": "blind_hole_plate", "size": {"x_mm": "16", "y_mm": "12", "z_mm": "2", "hole_radius_mm": "4", "hole_depth_mm": "1"}}
BLADE = {"part": "blade", "size": {"height_mm": "4", "chord_mm": "16", "lean_deg": "15"}}
TUBE = {"part": "tube", "size": {"height_mm": "2", "radius_mm": "6", "inner_radius_mm": "4.4"}}
SPHERE = {"part": "sphere", "size": {"radius_mm": "4", "segments": "48"}}
CONE = {"part": "cone", "size": {"radius_mm": "5", "height_mm": "5", "segments": "48"}}
CASING = {"part": "tube", "size": {"radius_mm": "50", "inner_radius_mm": "46.8", "height_mm": "2.4"}}
METAL = {"slicing.layer_height_mm": "0.8", "slicing.first_layer_height_mm": "0.8", "bead.width_mm": "1.6", "infill.density": "0",
         "skirt.count": "0", "feed.outer_wall_mm_s": "25", "feed.inner_wall_mm_s": "25"}


def cases_of_parts():
    """Yields (name, part, settings, extension)."""
    solid = {"infill.density": "1"}
    for part in (PLATE, BLADE, TUBE):
        for strategy in STRATEGIES:
            yield f"{part['part']}-{strategy}", part, {"infill.strategy": strategy}, "gcode"
            yield f"{part['part']}-{strategy}-solid", part, {"infill.strategy": strategy, **solid}, "gcode"
        for strategy in PATTERNS:
            yield f"{part['part']}-{strategy}", part, {"infill.strategy": strategy}, "gcode"
        for strategy in DROPS:
            settings = {"infill.strategy": strategy, "machine.name": "drop_printer", "walls.count": "0"}
            yield f"{part['part']}-{strategy}", part, settings, "gcode"
    yield "cone-vase", CONE, {"infill.strategy": "vase"}, "gcode"
    yield "plate-refilled", PLATE, {**solid, "voids.refill": "beads"}, "gcode"
    yield "plate-scanned", PLATE, {"scan.every_layers": "1"}, "gcode"
    yield "plate-copies", PLATE, {"part.copies": "3", "machine.name": "belt_45", "slicing.plane.angle_deg": "45"}, "gcode"
    yield "sphere-smoothed", SPHERE, {"smoothing.window_mm": "1"}, "gcode"
    for mode in ("planar", "adapted", "curved", "conformal", "heightfield", "auto"):
        for part in (BLADE, SPHERE, CONE):
            yield f"{part['part']}-{mode}", part, {"slicing.mode": mode}, "csv"
    yield "blade-inclined", BLADE, {"slicing.plane.angle_deg": "45", "machine.name": "large_gantry_45"}, "gcode"
    tilted = {"slicing.plane.angle_deg": "45", "machine.name": "large_gantry_45", "infill.strategy": "gyroid"}
    yield "blade-inclined-gyroid", BLADE, tilted, "gcode"
    for machine in ("five_axis_head_table", "five_axis_table_ac", "five_axis_head_ab"):
        yield f"blade-{machine}", BLADE, {"slicing.mode": "adapted", "machine.name": machine}, "gcode"
    for machine in ("irb_4600", "irb_4400", "irb_4600_turntable"):
        yield f"casing-{machine}", CASING, {**METAL, "machine.name": machine}, "mod"
    yield "casing-wire", CASING, {**METAL, "machine.name": "irb_4600", "rapid.variant": "wire_3_axes"}, "mod"
    for language in ("src", "script", "ls", "jbi"):
        yield f"casing-{language}", CASING, {**METAL, "machine.name": "irb_4600"}, language
    yield "blade-without-skirt", BLADE, {"skirt.count": "0"}, "gcode"


def cases_of_models(folder):
    for mesh in sorted(pathlib.Path(folder).glob("*.stl")):
        part = {"part": str(mesh), "size": {}}
        for strategy in STRATEGIES:
            yield f"{mesh.stem}-{strategy}", part, {"infill.strategy": strategy}, "gcode"
        yield f"{mesh.stem}-contour-solid", part, {"infill.strategy": "contour", "infill.density": "1"}, "gcode"
        yield f"{mesh.stem}-heightfield", part, {"slicing.mode": "heightfield"}, "csv"
        yield f"{mesh.stem}-conformal", part, {"slicing.mode": "conformal"}, "csv"
        inclined = {"slicing.plane.angle_deg": "45", "machine.name": "large_gantry_45", "anchoring.strategy": "none"}
        yield f"{mesh.stem}-inclined", part, inclined, "gcode"


def arguments_of(settings):
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else "refused"


def sliced(lamina, folder, case):
    """The lines of one case: its program, and what other commands make of it."""
    name, part, settings, extension = case
    mesh = part["part"]
    if part["size"]:
        mesh = folder / f"{name}.stl"
        subprocess.run([lamina, "part", part["part"], *arguments_of(part["size"]), "-o", mesh], check=True, capture_output=True)
    output = folder / f"{name.replace('-', '_')}.{extension}"
    subprocess.run([lamina, "slice", mesh, *arguments_of({**COARSE, **settings}), "--threads", "2", "-o", output],
                   capture_output=True, check=False)
    return [(name, digest(output))]


def derived(lamina, folder):
    """Programs made of programs: inclined, filled, swept, deposited; and scaffolds."""
    plate = folder / "blind_hole_plate_zigzag.gcode"
    level = folder / "blade_without_skirt.gcode"
    drops = folder / "blind_hole_plate_drops_raster.gcode"
    made = {
        "incline": ("gcode", ["incline", level, "--angle-deg", "30"]),
        "fill-voids": ("gcode", ["fill-voids", plate, "--part", folder / "blind_hole_plate-zigzag.stl"]),
        "fill-drop-voids": ("gcode", ["fill-voids", drops]),
        "sweep": ("stl", ["sweep", folder / "tube_contour.gcode"]),
        "deposit": ("stl", ["deposit", folder / "tube_contour.gcode"]),
        "coordinates": ("csv", ["coordinates", plate]),
        "turn": ("stl", ["turn", folder / "blade-zigzag.stl"]),
        "scaffold-sinusoidal": ("gcode", ["scaffold", "sinusoidal"]),
        "scaffold-cube": ("gcode", ["scaffold", "cube"]),
    }
    for name, (extension, command) in made.items():
        output = folder / f"made_{name}.{extension}"
        subprocess.run([lamina, *command, "-o", output], capture_output=True, check=False)
        yield name, digest(output)


def measured(lamina, cases, with_derived):
    with tempfile.TemporaryDirectory(prefix="lamina_golden_") as scratch:
        folder = pathlib.Path(scratch)
        with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
            lines = [line for found in pool.map(lambda case: sliced(lamina, folder, case), cases) for line in found]
        if with_derived:
            lines += derived(lamina, folder)
    return dict(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lamina")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--models")
    parser.add_argument("--list", type=pathlib.Path, default=LIST)
    arguments = parser.parse_args()
    cases = list(cases_of_models(arguments.models) if arguments.models else cases_of_parts())
    found = measured(arguments.lamina, cases, not arguments.models)
    text = "".join(f"{value}  {name}\n" for name, value in sorted(found.items()))
    if arguments.write:
        arguments.list.write_text(text)
        return 0
    expected = dict(reversed(line.split("  ", 1)) for line in arguments.list.read_text().splitlines())
    changed = sorted(name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name))
    for name in changed:
        print(f"{name}: {found.get(name, 'not made')}; expected {expected.get(name, 'nothing')}")
    print(f"{len(found) - len(changed)} of {len(expected)} programs are as listed")
    return 1 if changed or not expected else 0


if __name__ == "__main__":
    sys.exit(main())
