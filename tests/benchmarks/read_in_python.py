#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the cost for a Python program of reading every packet of a robot at 500 Hz.

    PYTHONPATH=build/release/python python3 tests/benchmarks/read_in_python.py build/release/bin/tests/tiller_python_robot [60]

The robot is simulated in a separate process in real time. Two readers run one after the other:
`tiller.Robot.samples()`, which returns every packet once, and `rtde_receive` polled once per period, as in programs
written for ur_rtde. For each reader, the table contains the numbers of packets sent by the controller, read, read twice
and missed, and the processor time of this process, including the receive thread, as a fraction of one core. Exits with 1
if samples() missed or repeated a packet.
"""
import subprocess
import sys
import time

import rtde_receive
import tiller

PERIOD = 0.002  # [s]


def measure(read, seconds):
    """Returns (timestamps read, fraction of a core)."""
    stamps = []
    busy = time.process_time()
    begin = time.monotonic()
    read(stamps, begin + seconds)
    return stamps, (time.process_time() - busy) / (time.monotonic() - begin)


def report(name, stamps, share):
    sent = round((stamps[-1] - stamps[0]) / PERIOD) + 1
    once = len({round(stamp / PERIOD) for stamp in stamps})
    print(f"{name:<28}{sent:>8}{len(stamps):>8}{len(stamps) - once:>8}{sent - once:>8}{100 * share:>9.1f} %")
    return len(stamps) == once == sent


def every_packet(address):
    def read(stamps, end):
        with tiller.Robot(address, timeout=30) as robot:
            for sample in robot.samples():
                stamps.append(sample.time)
                if sample.q[0] != sample.q[0] or sample.tcp_force.shape != (6,):
                    raise RuntimeError("a packet without joint positions or force")
                if time.monotonic() > end:
                    break
    return read


def polled(address):
    def read(stamps, end):
        with rtde_receive.RTDEReceiveInterface(address) as receive:
            while time.monotonic() < end:
                begin = receive.initPeriod()
                stamps.append(receive.getTimestamp())
                receive.getActualQ()
                receive.getActualTCPForce()
                receive.waitPeriod(begin)
    return read


def main():
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    robot = subprocess.Popen([sys.argv[1], "real"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        address = robot.stdout.readline().strip()
        print(f"{seconds:.0f} s each, controller simulated")
        print(f"{'':<28}{'sent':>8}{'read':>8}{'twice':>8}{'missed':>8}{'of a core':>11}")
        complete = report("tiller.Robot.samples()", *measure(every_packet(address), seconds))
        report("rtde_receive, polled", *measure(polled(address), seconds))
    finally:
        robot.stdin.close()
        robot.wait()
    return 0 if complete else 1


if __name__ == "__main__":
    sys.exit(main())
