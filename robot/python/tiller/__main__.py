# SPDX-License-Identifier: MIT
"""python -m tiller COMMAND: runs the commands of tiller-cli ("simulate", "doctor" ...), which is included in the wheel."""
from __future__ import annotations

import os
import pathlib
import shutil
import sys


def main() -> None:
    """Replaces this process by tiller-cli, so that signals and the exit status are passed through."""
    own = pathlib.Path(__file__).parent / "bin" / "tiller-cli"
    program = str(own) if own.exists() else shutil.which("tiller-cli")
    if program is None:
        sys.exit("tiller: tiller-cli was not found. Install the wheel, or the package tiller-cli of the distribution.")
    os.execv(program, ["tiller-cli", *sys.argv[1:]])


if __name__ == "__main__":
    main()
