# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same job as a command of each slicer, for the scripts that compare them.

Each function gives a command and what it adds to the environment. CuraEngine on the command line knows defaults only and
evaluates no formula: distances of lines are stated.
"""
import math
import os
import pathlib
import subprocess

from slicer_runs import PLAIN

LAYER_MM = "0.2"
WIDTH_MM = "0.4"
DENSITY = 0.15
SUPPORT_ANGLE_DEG = 45
# Feeds [mm/s] of a job that all three are to run alike, without least layer times.
OUTER_WALL, INNER_WALL, SOLID, INFILL, FIRST_LAYER, TRAVEL = 30, 45, 45, 60, 20, 150
LAMINA_FEEDS = {"feed.outer_wall_mm_s": OUTER_WALL, "feed.inner_wall_mm_s": INNER_WALL, "feed.skin_mm_s": SOLID,
                "feed.top_skin_mm_s": SOLID, "feed.infill_mm_s": INFILL, "feed.first_layer_mm_s": FIRST_LAYER,
                "feed.bridge_mm_s": SOLID, "travel.feed_mm_s": TRAVEL}
# CuraEngine's beads are rectangles: lines as far apart, of the same section, are beads of this width [mm].
SECTION_WIDTH = float(WIDTH_MM) + (1 - math.pi / 4) * float(LAYER_MM)
LAMINA_SECTIONS = {f"{role}.bead_width_mm": f"{SECTION_WIDTH:.5f}" for role in ("infill", "skins")}
PRUSA_FEEDS = ["--external-perimeter-speed", OUTER_WALL, "--perimeter-speed", INNER_WALL, "--small-perimeter-speed", INNER_WALL,
               "--solid-infill-speed", SOLID, "--top-solid-infill-speed", SOLID, "--bridge-speed", SOLID, "--infill-speed", INFILL,
               "--first-layer-speed", FIRST_LAYER, "--travel-speed", TRAVEL, "--slowdown-below-layer-time", 0]
CURA_FEEDS = {"speed_wall_0": OUTER_WALL, "speed_wall_x": INNER_WALL, "speed_topbottom": SOLID, "speed_roofing": SOLID,
              "speed_infill": INFILL, "speed_print_layer_0": FIRST_LAYER, "speed_layer_0": FIRST_LAYER, "speed_travel": TRAVEL,
              "speed_travel_layer_0": TRAVEL, "speed_slowdown_layers": 1, "cool_min_layer_time": 0}


def cura_resources():
    """Cura's definitions, without installing Cura."""
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "lamina" / "cura"
    resources = cache / "usr" / "share" / "cura" / "resources"
    if not resources.is_dir():
        cache.mkdir(parents=True, exist_ok=True)
        subprocess.run(["apt-get", "download", "cura"], cwd=cache, check=True, stdout=subprocess.DEVNULL)
        package = next(cache.glob("cura_*.deb"))
        subprocess.run(["dpkg-deb", "-x", package.name, "."], cwd=cache, check=True)
    return resources


def lamina_command(executable, mesh, output, skins, support=None, feeds="own"):
    settings = {
        "slicing.layer_height_mm": LAYER_MM, "slicing.first_layer_height_mm": LAYER_MM, "bead.width_mm": WIDTH_MM,
        "walls.count": 2, "infill.strategy": "zigzag", "infill.density": DENSITY, "skirt.count": 0,
        **PLAIN, "skins.top_layers": skins, "skins.bottom_layers": skins,
    }
    if support:
        settings.update({"supports.use": "true", "supports.kind": support, "supports.angle_deg": SUPPORT_ANGLE_DEG})
    if feeds != "own":
        settings.update(LAMINA_FEEDS)
    if feeds.startswith("common, sections of rectangles"):
        settings.update(LAMINA_SECTIONS)
    if feeds.endswith("lines not joined"):
        settings["infill.link"] = "none"
    assignments = [text for key, value in settings.items() for text in ("--set", f"{key}={value}")]
    return [executable, "slice", mesh, "-o", output, "--json", *assignments], {}


def prusa_command(executable, mesh, output, skins, support=None, feeds="own"):
    supports = ["--support-material", "--support-material-threshold", str(SUPPORT_ANGLE_DEG),
                "--support-material-spacing", f"{float(WIDTH_MM) / DENSITY:.4f}"] if support else []
    return [
        executable, "--export-gcode", "--layer-height", LAYER_MM, "--first-layer-height", LAYER_MM,
        "--nozzle-diameter", "0.4", "--extrusion-width", WIDTH_MM, "--filament-diameter", "1.75",
        "--perimeters", "2", "--fill-density", f"{100 * DENSITY:g}%", "--fill-pattern", "rectilinear",
        "--top-solid-layers", str(skins), "--bottom-solid-layers", str(skins), "--solid-infill-below-area", "0",
        "--gap-fill-speed", "0", "--skirts", "0", "--brim-width", "0", "--center", "100,100", *supports,
        *(map(str, PRUSA_FEEDS) if feeds == "common" else []),
        "--output", output, mesh,
    ], {}


def cura_environment():
    resources = cura_resources()
    return {"CURA_ENGINE_SEARCH_PATH": f"{resources / 'definitions'}:{resources / 'extruders'}"}


def cura_definition():
    return str(cura_resources() / "definitions" / "fdmprinter.def.json")


def cura_command(executable, mesh, output, skins, support=None, feeds="own"):
    distance = float(WIDTH_MM) / DENSITY
    settings = {
        "layer_height": LAYER_MM, "layer_height_0": LAYER_MM, "line_width": WIDTH_MM, "wall_line_width": WIDTH_MM,
        "wall_line_width_0": WIDTH_MM, "wall_line_width_x": WIDTH_MM, "infill_line_width": WIDTH_MM,
        "wall_line_count": 2, "wall_thickness": 0.8, "top_layers": skins, "bottom_layers": skins,
        "initial_bottom_layers": skins,
        "infill_sparse_density": 100 * DENSITY, "infill_line_distance": distance,
        "infill_pattern": "lines", "adhesion_type": "none", "machine_width": 300, "machine_depth": 300,
        "machine_height": 300, "center_object": "true", "material_diameter": 1.75,
    }
    if support:
        settings.update({
            "support_enable": "true", "support_structure": "tree" if support == "tree" else "normal",
            "support_type": "everywhere", "support_angle": SUPPORT_ANGLE_DEG, "support_line_distance": distance,
            "support_initial_layer_line_distance": distance, "support_infill_rate": 100 * DENSITY,
            "support_top_distance": 0.2, "support_bottom_distance": 0.2, "support_z_distance": 0.2,
            "support_infill_sparse_thickness": LAYER_MM,
        })
    if feeds == "common":
        settings.update(CURA_FEEDS)
    assignments = [text for key, value in settings.items() for text in ("-s", f"{key}={value}")]
    command = [executable, "slice", "-j", cura_definition(), *assignments, "-e0", *assignments, "-l", mesh, "-o",
               output]
    return command, cura_environment()


def bare_lamina_command(executable, mesh, output):
    return [executable, "slice", mesh, "-o", output], {}


def bare_prusa_command(executable, mesh, output):
    return [executable, "--export-gcode", "--output", output, mesh], {}


def bare_cura_command(executable, mesh, output):
    return [executable, "slice", "-j", cura_definition(), "-l", mesh, "-o", output], cura_environment()
