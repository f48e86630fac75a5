# SPDX-License-Identifier: MIT
"""python -m tiller_simulator [options]: runs a simulated controller until Ctrl+C, like `tiller-cli simulate`."""
import os
import sys

from . import PROGRAM


def main() -> None:
    # Replaces this process, so that signals and the exit status are those of the program.
    os.execv(PROGRAM, [PROGRAM, "simulate", *sys.argv[1:]])


if __name__ == "__main__":
    main()
