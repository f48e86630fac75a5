#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the cost of opening an hour of 24 columns at 500 Hz as CSV with Tiller, pandas and LabPlot.

    xvfb-run -a tests/benchmarks/csv_beside_others.py build/release/bin/tiller-cli [--hours H] [--folder F] [--json]

The file (500 MB per hour) is created first and deleted afterwards. The programs run one after the other, and their
processor time and peak memory are measured. `tiller-cli info` reads all values, like the plots when they open a file.
pandas uses read_csv(). LabPlot opens a project that refers to the file, needs a display, and counts as finished when
its processor time stops increasing. Programs that are not installed are reported and skipped.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TICKS = os.sysconf("SC_CLK_TCK")
COLUMNS = 24
RATE = 500  # [Hz]

# The shortest project file that LabPlot 2.9 reads.
PROJECT = """<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE LabPlotXML>
<project version="2.9.0" xmlVersion="9" fileName="" modificationTime="2026-01-01 10:00:00:000" author="">
 <comment></comment>
 <child_aspect><liveDataSource creation_time="2026-01-01 10:00:00:000" name="hour">
  <comment></comment>
  <general fileName="{file}" fileType="0" fileWatched="0" updateInterval="1000" updateType="1" readingType="2" \
sourceType="0" keepNValues="0" fileLinked="1" relativePath="0"/>
  <asciiFilter commentCharacter="#" separatingCharacter="," autoMode="0" createIndex="0" createTimestamp="0" header="1" \
vectorNames="" skipEmptyParts="0" simplifyWhitespaces="0" nanValue="0" removeQuotes="0" startRow="1" endRow="-1" \
startColumn="1" endColumn="-1" baseYear="0"/>
 </liveDataSource></child_aspect>
 <state><view state="1" path="Project"/></state>
</project>
"""


def make(path, rows):
    fields = [("actual_q", 6), ("actual_qd", 6), ("actual_TCP_force", 6), ("actual_current", 5)]
    names = ["timestamp"] + [f"{field}_{i}" for field, count in fields for i in range(count)]
    tails = [",".join(f"{math.sin(k * 0.01 + i) + (k * 2654435761 + i * 40503) % 4096 / 4e6:.9g}"
                      for i in range(1, COLUMNS)) for k in range(1000)]
    with open(path, "w", encoding="ascii") as file:
        file.write(",".join(names) + "\n")
        for begin in range(0, rows, 10_000):
            file.writelines(f"{100 + row / RATE:.3f},{tails[row % 1000]}\n"
                            for row in range(begin, min(rows, begin + 10_000)))


def measure(command, environment=None):
    """Returns processor time [s] and peak memory [MB] of a program that exits by itself."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               env={**os.environ, **(environment or {})})
    said = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):  # 1: info reports a problem in the file
        sys.exit(f"{command[0]}: {said.decode(errors='replace').strip()}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def watch(command, environment, least, timeout=900):
    """Like measure(), for a program with a window. The program is finished when it has used `least` memory [MB], which it
    needs to read the file, and its processor time has not increased for 10 s. Returns None if it has not read the file."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env={**os.environ, **environment})
    spent, most, still = 0.0, 0.0, time.monotonic()
    begin = still
    try:
        while process.poll() is None and time.monotonic() - begin < (timeout if most > least else 120):
            if most > least and time.monotonic() - still > 10:
                break
            time.sleep(0.5)
            fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
            now = (int(fields[11]) + int(fields[12])) / TICKS
            for line in Path(f"/proc/{process.pid}/status").read_text(encoding="ascii").splitlines():
                if line.startswith("VmHWM:"):
                    most = int(line.split()[1]) / 1024
            if now - spent > 0.02:
                spent, still = now, time.monotonic()
    except OSError:
        pass
    finally:
        process.kill()
        process.wait()
    return (spent, most) if most > least else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tiller_cli")
    parser.add_argument("--hours", type=float, default=1)
    parser.add_argument("--folder", help="where the file is made")
    parser.add_argument("--json", action="store_true")
    wanted = parser.parse_args()
    table = {}
    with tempfile.TemporaryDirectory(dir=wanted.folder) as folder:
        path = os.path.join(folder, "hour.csv")
        make(path, int(wanted.hours * 3600 * RATE))
        table["Tiller"] = measure([wanted.tiller_cli, "info", path])
        python = "/usr/bin/python3"
        if subprocess.run([python, "-c", "import pandas"], stderr=subprocess.DEVNULL, check=False).returncode == 0:
            table["pandas"] = measure([python, "-c", f"import pandas; assert len(pandas.read_csv({path!r})) > 1"])
        else:
            print("pandas is not installed (python3-pandas)", file=sys.stderr)
        labplot = shutil.which("labplot2")
        if labplot and not os.environ.get("DISPLAY"):
            print("LabPlot needs a display: xvfb-run -a", sys.argv[0], "...", file=sys.stderr)
        elif labplot:
            project = os.path.join(folder, "hour.lml")
            Path(project).write_text(PROJECT.format(file=path), encoding="utf-8")
            read = watch([labplot, "--no-splash", project], {"QT_QPA_PLATFORM": "xcb", "HOME": folder},
                         least=os.path.getsize(path) / 2e6)
            if read:
                table["LabPlot"] = read
            else:
                print("LabPlot did not read the file", file=sys.stderr)
        else:
            print("LabPlot is not installed (labplot)", file=sys.stderr)
    if wanted.json:
        print(json.dumps({name: {"cpu_s": round(cpu, 2), "memory_mb": round(memory)}
                          for name, (cpu, memory) in table.items()}))
    else:
        print(f"{wanted.hours:g} h of {COLUMNS} columns at {RATE} Hz, as CSV")
        for name, (cpu, memory) in table.items():
            print(f"{name:<10}{cpu:>8.1f} s of processor time{memory:>8.0f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
