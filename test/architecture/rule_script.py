"""What every rule of this folder does when it is called: prints what breaks it in the folder that is given, the current one if none is."""
import pathlib
import sys


def report(faults):
    """Ends the script: exit code 1 if there is a fault.
    faults(root)  yields a line for each fault below a folder"""
    found = list(faults(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found))
    sys.exit(1 if found else 0)
