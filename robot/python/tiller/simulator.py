# SPDX-License-Identifier: MIT
"""A simulated controller in this process. Uses the real protocols on a separate loopback address and runs URScript."""
from __future__ import annotations

import contextlib
import itertools
import os
import weakref
from collections.abc import Iterator
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any

from . import _native
from ._arguments import checked
from ._values import Array, Floats, Joints, Pose, floats, joint_positions, one_of
from .modes import RobotMode, RuntimeState, SafetyMode
from .receive import DIGITAL_PINS

if TYPE_CHECKING:
    from .robot import Robot

_numbers = itertools.count(1)
_simulators: weakref.WeakSet[Simulator] = weakref.WeakSet()


def stop_all() -> None:
    """Called at the end of the process, after all other threads have stopped running Python code."""
    for simulator in list(_simulators):
        simulator.stop()


def forget_all() -> None:
    """Called in a forked child, because the simulators run in the parent process."""
    _simulators.clear()


def _own_address() -> str:
    """A loopback address that is unique on this machine, so that simulators with standard ports can run in parallel."""
    pid = os.getpid()
    return f"127.{10 + pid % 200}.{pid // 200 % 250}.{next(_numbers) % 250 + 2}"


@dataclass(frozen=True)
class SimulatedState:
    """The actual state of a simulated arm."""

    timestamp: float  #: controller time [s]
    robot_mode: RobotMode
    safety_mode: SafetyMode
    runtime_state: RuntimeState
    q: Joints  #: joint positions [rad]
    qd: Array  #: joint velocities [rad/s]
    tcp_pose: Pose  #: in the base frame [m, rad]
    tcp_speed: Array  #: in the base frame [m/s, rad/s]
    speed_slider: float  #: 0 ... 1
    digital_outputs: int  #: bit 0 is output 0


@checked
class Simulator:
    """A simulated robot, powered on with its brakes released.

        with tiller.Simulator() as simulator:
            robot = tiller.Robot(simulator.address)

    model: e.g. "UR5e". software: e.g. "5.22.1". address: address to listen on; None: a separate loopback address, available
    immediately as `simulator.address`. start: joint positions [rad]. programs: folder from which the dashboard server
    loads programs.
    priority: SCHED_FIFO priority of the simulator's thread in real time, if permitted; 0: normal priority. A real
    controller does not wait for clients, so this thread has precedence over their threads.
    virtual: time advances only in step() and while a method of one of its robots waits. The simulation runs as fast as
    the machine allows, with the same result on every machine. Create the robots with simulator.robot().
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
        """Opens the ports. Raises Rejected if a port is in use; the error contains the port and a suggested action."""
        self._native.start()
        return self

    def stop(self) -> None:
        """Ends the simulator and every connection. No effect if it is not running."""
        self._native.stop()

    @property
    def running(self) -> bool:
        """True if the simulator is running."""
        return self._native.is_running()

    def robot(self, **options: Any) -> Robot:
        """Returns a Robot connected to the simulator; options as for Robot. In virtual time it uses the simulator's clock."""
        from .robot import Robot

        return Robot(self.address, simulator=self if self.virtual else None, **options)

    def step(self, seconds: float) -> None:
        """Advances virtual time [s] by whole control periods; all robots created by robot() process each period."""
        if not self.virtual:
            raise ValueError("step() requires Simulator(virtual=True): this simulator runs in real time")
        self._native.step(seconds)

    @contextlib.contextmanager
    def flowing(self) -> Iterator[None]:
        """Lets virtual time advance in the background while the block runs."""
        if not self.virtual:
            yield
            return
        self._native.begin_flow()
        try:
            yield
        finally:
            self._native.end_flow()

    def fault(self, words: str) -> str:
        """Triggers a fault by its name: "protective-stop", "delay 20 5"; "help" lists all faults."""
        return self._native.inject(words)

    def set_digital_input(self, number: int, on: bool) -> None:
        """Sets a digital input: 0-7 standard, 8-15 configurable, 16-17 tool. Raises InvalidArgument for any other number."""
        one_of(number, "number", DIGITAL_PINS)
        self._native.set_digital_input(number, on)

    def set_analog_input(self, number: int, value: float) -> None:
        """Sets an analog input: 0, 1 [A or V]; 2, 3 of the tool. Raises InvalidArgument for any other number."""
        one_of(number, "number", range(4))
        self._native.set_analog_input(number, value)

    def press_hand(self, wrench: Floats) -> None:
        """Applies an external wrench to the tool [N, Nm] at the TCP, in the base frame; zeros remove it."""
        self._native.press_hand(floats(wrench, "wrench"))

    @property
    def truth(self) -> SimulatedState:
        """The actual state of the simulated arm."""
        values = self._native.truth()
        for name, kind in (("robot_mode", RobotMode), ("safety_mode", SafetyMode), ("runtime_state", RuntimeState)):
            values[name] = kind(values[name])
        values["q"] = values["q"].view(Joints)
        values["tcp_pose"] = values["tcp_pose"].view(Pose)
        return SimulatedState(**values)

    def __enter__(self) -> Simulator:
        return self.start()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        time = "virtual time" if self.virtual else "real time"
        return f"<tiller.Simulator {self.address}, {time}, {'running' if self.running else 'stopped'}>"
