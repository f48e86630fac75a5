# SPDX-License-Identifier: MIT
"""A simulated Universal Robots controller for tests, in a separate process.

    from tiller_simulator import Simulator

    with Simulator("--model", "ur10e") as robot:
        client.connect(robot.address)        # any client: the ports are those of a real controller
        robot.fault("protective-stop")

It provides the RTDE, dashboard, primary and secondary interfaces, and runs URScript. For pytest, the fixture
`simulated_controller` is a controller that is ready to move.
"""
from __future__ import annotations

import itertools
import os
import pathlib
import subprocess
from types import TracebackType

__all__ = ["PROGRAM", "Simulator"]

PROGRAM = str(pathlib.Path(__file__).parent / "bin" / "tiller-cli")
_numbers = itertools.count(1)


def _own_address() -> str:
    """A loopback address, different per process and call, so that tests with standard ports can run in parallel."""
    pid = os.getpid()
    return f"127.{10 + pid % 200}.{pid // 200 % 250}.{next(_numbers) % 250 + 2}"


class Simulator:
    """A simulated controller that runs until stop().

    options: options of `tiller-simulate`; see its --help. Without --listen, the controller uses a separate address.
    headless: the arm is powered on with released brakes, and the controller is in remote control.
    Raises RuntimeError with the error output if the controller does not start.
    """

    def __init__(self, *options: str, address: str | None = None, headless: bool = True) -> None:
        self.address = _own_address() if address is None else address
        command = [PROGRAM, "simulate", "--listen", self.address, *(["--headless"] if headless else []), *options]
        self._process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                         stderr=subprocess.PIPE, text=True)
        assert self._process.stdout is not None and self._process.stderr is not None
        self.ports: dict[str, int] = {}
        ready = self._process.stdout.readline()
        if not ready.startswith("ready "):
            self._process.wait()
            raise RuntimeError(self._process.stderr.read().strip() or "the simulator ended before it was ready")
        for word in ready.split()[2:]:
            name, _, port = word.partition("=")
            self.ports[name] = int(port)

    def fault(self, words: str) -> str:
        """Injects a fault, e.g. "protective-stop" or "delay 20 5". Raises ValueError for an unknown fault."""
        done = subprocess.run([PROGRAM, "fault", f"{self.address}:{self.ports['faults']}", *words.split()],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ValueError(done.stderr.strip())
        return done.stdout.strip()

    def stop(self) -> None:
        """Ends the controller and all connections to it. Has no effect if it has already ended."""
        self._process.terminate()
        self._process.communicate()

    def __enter__(self) -> Simulator:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()
