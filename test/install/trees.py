"""Trees of installed files for the tests beside this file; each is called with source folder, build folder, scratch folder, and
the devel space, or `none` without ROS."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE, BUILD, SCRATCH, DEVEL = (pathlib.Path(argument) for argument in sys.argv[1:5])
HAS_ROS = DEVEL.name != "none"
del sys.argv[1:5]

RUN_PATH = re.compile(r"\(RU?N?PATH\).*\[(.*)\]")
# What a person has who has not sourced the build's own setup file.
ENVIRONMENT = {name: value for name, value in os.environ.items()
               if name not in ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "ROS_PACKAGE_PATH", "PYTHONPATH")}


def empty_scratch():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)


def leave_nothing_to_find():
    """Empties the scratch folder: it lies in the source tree, in which roslaunch looks for launch files by name."""
    shutil.rmtree(SCRATCH, ignore_errors=True)


def run(*command, **options):
    """What the command prints; an error with all of it where the command fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=ENVIRONMENT, check=False, **options)
    assert done.returncode == 0, f"{command} ends with {done.returncode}:\n{done.stdout}"
    return done.stdout


def is_program(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def run_paths(tree):
    """Yields (program or library, where it looks for libraries)."""
    for path in sorted(tree.rglob("*")):
        if path.is_file() and not path.is_symlink() and is_program(path):
            yield path, RUN_PATH.findall(run("readelf", "-d", path))


def build_paths(tree):
    """Yields each text file that names the source or build folder."""
    for path in sorted(tree.rglob("*")):
        if path.is_file() and not is_program(path) and path.suffix != ".pyc":
            text = path.read_bytes()
            if str(SOURCE).encode() in text or str(BUILD).encode() in text:
                yield path


def deposited_mm(program):
    """Filament that a program extrudes, by its own relative E words: the sum without retractions."""
    extruded = (float(word) for line in program.read_text().splitlines() if re.match(r"G1 .*[XY]", line)
                for word in re.findall(r"E(-?[\d.]+)", line.split(";")[0]))
    return sum(extruded)


def run_commands_with_libraries_of_their_own(tree):
    """Runs those that look for more of the tree than the core: what draws, what collides, what searches."""
    lamina = tree / "bin/lamina"
    run(lamina, "preview", "box", "-o", SCRATCH / "box.png")
    run(lamina, "check", "box", "--machine", "cartesian_gantry")
    run(lamina, "optimise", tree / "share/doc/lamina/examples/studies/mini_specimens.yaml", "-o", SCRATCH / "study")


def layers(program):
    return program.read_text().count(";LAYER:")
