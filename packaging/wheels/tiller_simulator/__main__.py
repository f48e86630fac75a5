# SPDX-License-Identifier: MIT
"""python -m tiller_simulator [options]: a simulated controller until Ctrl-C, as `tiller-cli simulate`."""
import os
import sys

from . import PROGRAM


def main() -> None:
    # In its place, so that signals and the exit status are its own.
    os.execv(PROGRAM, [PROGRAM, "simulate", *sys.argv[1:]])


if __name__ == "__main__":
    main()
