# SPDX-License-Identifier: MIT
"""The simulated controller in this process: real protocols on a loopback address of its own, real URScript."""
from __future__ import annotations

import contextlib
import itertools
import os
import weakref
from collections.abc import Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import checked
from ._values import Floats, floats, joint_positions, one_of
from .receive import DIGITAL_PINS

if TYPE_CHECKING:
    from .robot import Robot

_numbers = itertools.count(1)
_simulators: weakref.WeakSet[Simulator] = weakref.WeakSet()


def stop_all() -> None:
    """For the end of the process, where no other thread runs Python any more."""
    for simulator in list(_simulators):
        simulator.stop()


def forget_all() -> None:
    """For a forked child: the simulators run in the parent process."""
    _simulators.clear()


def _own_address() -> str:
    """A loopback address nobody else on this machine has, so that simulators run side by side with standard ports."""
    pid = os.getpid()
    return f"127.{10 + pid % 200}.{pid // 200 % 250}.{next(_numbers) % 250 + 2}"


@checked
class Simulator:
    """A simulated robot, powered on with its brakes released.

        with tiller.Simulator() as simulator:
            robot = tiller.Robot(simulator.address)

    model: "UR5e" ...; software: "5.22.1"; address: where it listens, None: a loopback address of its own, which is in
    `simulator.address` from the beginning. start: joint positions [rad]. programs: folder of the programs that the
    dashboard loads. priority: of its thread in real time, SCHED_FIFO where permitted, 0 for none: a controller waits for
    nobody, so it goes before the threads that talk to it.
    virtual: time goes on only while a call of its robots waits, and in step(): as fast as the machine can, and with the
    same result on every machine. Its robots are made by simulator.robot().
    """

    def __init__(self, model: str = "UR5e", *, software: str = "", address: str | None = None, virtual: bool = False,
                 powered_on: bool = True, start: Floats | None = None, remote_control: bool = True,
                 programs: str = "", priority: int = 95) -> None:
        self.address = _own_address() if address is None else address
        self.virtual = virtual
        self._native = _native.Simulator(model, software, self.address, virtual, powered_on,
                                         None if start is None else joint_positions(start, "start"), remote_control, programs,
                                         0 if virtual else priority)
        _simulators.add(self)

    def start(self) -> Simulator:
        """Opens the ports. Raises Rejected when one is in use, naming it and what to do."""
        self._native.start()
        return self

    def stop(self) -> None:
        """Ends the simulator and every connection. Harmless when it does not run."""
        self._native.stop()

    @property
    def running(self) -> bool:
        """Whether it runs."""
        return self._native.is_running()

    def robot(self, **options: Any) -> Robot:
        """A Robot connected to it; options as Robot takes them. In virtual time it lives by the simulator's clock."""
        from .robot import Robot

        return Robot(self.address, simulator=self if self.virtual else None, **options)

    def step(self, seconds: float) -> None:
        """Moves virtual time on [s], by whole control periods; every client of robot() follows each of them."""
        if not self.virtual:
            raise ValueError("step() is for Simulator(virtual=True): here time goes on by itself")
        self._native.step(seconds)

    @contextlib.contextmanager
    def flowing(self) -> Iterator[None]:
        """Virtual time goes on in the background while the block runs."""
        if not self.virtual:
            yield
            return
        self._native.begin_flow()
        try:
            yield
        finally:
            self._native.end_flow()

    def fault(self, words: str) -> str:
        """Makes something go wrong, by its words: "protective-stop", "delay 20 5"; "help" lists all."""
        return self._native.inject(words)

    def set_digital_input(self, number: int, on: bool) -> None:
        """0-7 standard, 8-15 configurable, 16-17 tool. Raises InvalidArgument for another number."""
        one_of(number, "number", DIGITAL_PINS)
        self._native.set_digital_input(number, on)

    def set_analog_input(self, number: int, value: float) -> None:
        """0, 1 [A or V]; 2, 3 are the tool's. Raises InvalidArgument for another number."""
        one_of(number, "number", range(4))
        self._native.set_analog_input(number, value)

    def press_hand(self, wrench: Floats) -> None:
        """A hand on the tool [N, Nm] at the TCP, in the base frame; zeros let go."""
        self._native.press_hand(floats(wrench, "wrench"))

    @property
    def truth(self) -> dict[str, Any]:
        """What the arm is really doing: timestamp [s], robot_mode, safety_mode, q [rad], qd [rad/s], tcp_pose [m, rad],
        tcp_speed [m/s, rad/s], speed_slider, digital_outputs."""
        return self._native.truth()

    def __enter__(self) -> Simulator:
        return self.start()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        time = "virtual time" if self.virtual else "real time"
        return f"<tiller.Simulator {self.address}, {time}, {'running' if self.running else 'stopped'}>"
