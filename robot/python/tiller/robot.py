# SPDX-License-Identifier: MIT
"""One robot: what it sends, and everything that can be asked of it."""
from __future__ import annotations

import atexit
import builtins
import contextlib
import functools
import os
import sys
import threading
import time
import weakref
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from types import TracebackType
from typing import Any

from . import _native, services, simulator as simulators
from ._arguments import checked
from ._values import ZEROS, Floats, Joints, Pose, floats, joint_positions, one_of, pose_numbers
from .errors import Error, NotConnected, RegisterInUse
from .motions import ForceMode, Jog, Move, PathMove, Stream
from .receive import Layout, Recording, Sample, Samples
from .simulator import Simulator

# What the robot reports of its outputs: followed in addition to the fields that were asked for.
_CONFIRMING = ("actual_digital_output_bits", "target_speed_fraction", "analog_io_types", "standard_analog_output0",
               "standard_analog_output1")
JOG_FRAMES = ("base", "tool", "custom", "joints")
_LOOP_TARGETS: dict[str, tuple[Callable[[Floats, str], list[float]], str]] = {
    "servo_j": (joint_positions, "joint positions"), "servo_l": (pose_numbers, "a pose"), "speed_j": (floats, "joint speeds"),
    "speed_l": (floats, "a tool speed"), "torque": (floats, "joint torques")}

_open: weakref.WeakSet[Robot] = weakref.WeakSet()
_recordings: weakref.WeakSet[Recording] = weakref.WeakSet()


@atexit.register
def _end_of_process() -> None:
    """Other threads that run until now are daemons: the interpreter is about to go, so none may return into it."""
    _native.park_other_threads()
    for recording in list(_recordings):
        with contextlib.suppress(Error):
            recording.stop()
    for robot in list(_open):
        robot.close()
    simulators.stop_all()


def _in_forked_child() -> None:
    """Threads and connections belong to the parent process: this one forgets them and touches none."""
    _native.forget_parent()
    for robot in list(_open):
        robot._links = None
        robot._why_closed = "this Robot was made before fork(): make another one in the child process"
    _open.clear()
    _recordings.clear()
    simulators.forget_all()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_in_forked_child)


def _brake_all() -> None:
    for robot in list(_open):
        with contextlib.suppress(Error):
            robot.stop()


@functools.lru_cache(maxsize=None)
def _watch_exceptions() -> None:
    """An exception that nothing catches ends what moves, at once: in the main thread, in others, in a notebook cell."""
    earlier, earlier_in_threads = sys.excepthook, threading.excepthook

    def uncaught(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        _brake_all()
        earlier(kind, error, trace)

    def uncaught_in_thread(arguments: threading.ExceptHookArgs) -> None:
        if arguments.exc_type is not SystemExit:
            _brake_all()
        earlier_in_threads(arguments)

    sys.excepthook, threading.excepthook = uncaught, uncaught_in_thread
    # IPython and Jupyter call no hook.
    shell = getattr(builtins, "get_ipython", lambda: None)()
    if shell is not None:
        def after_cell(result: Any) -> None:
            if not result.success:
                _brake_all()

        shell.events.register("post_run_cell", after_cell)


@dataclass(frozen=True)
class LoopReport:
    """How a packet loop went.

    cycles: calls of the callback. missed: control periods without one. stale: cycles that ran in time but whose packet did
    not come; the callback saw the values before. late: cycles that began more than half a period late. overruns: calls
    that took longer than a period. longest_call [s]. longest_wait: the longest that a call waited for other Python threads
    (the interpreter lock), part of its time [s]. fast_wake_ups: the system kept its
    processors from deep sleep meanwhile. A few stale or late ones are a busy machine's; many missed ones make
    the motion rough.
    """

    cycles: int
    missed: int  #: control periods without a cycle
    stale: int  #: cycles that ran in time, whose packet did not come
    late: int  #: cycles that began more than half a period late
    overruns: int  #: calls that took longer than a period
    longest_call: float  #: [s]
    longest_wait: float = 0.0  #: for the interpreter lock [s]
    fast_wake_ups: bool = False  #: the system kept its processors from deep sleep meanwhile


@checked
class Robot:
    """A connection to a robot.

        with tiller.Robot("192.168.0.10") as robot:
            print(robot.state.tcp_pose)
            robot.take_control()
            robot.move_j(robot.state.q + [0.1, 0, 0, 0, 0, 0]).wait()

    Data come at once; control is taken by take_control(). A connection that is refused is not tried again. address: of the controller. fields: RTDE outputs to follow,
    None: what most programs want. frequency: packets a second [Hz]; 0: as many as the controller gives. speed_cap: no
    command makes TCP or elbow faster than this [m/s]; it binds moves too. timeout: for the first packet [s].
    upper_registers: talk through registers 24-47 rather than 0-23. priority: of the threads that receive and control, 0
    for none.
    Every method may be called from any thread and lets other Python threads run while it waits; Ctrl-C ends every wait.
    Only in a callback of packet_loop() calls that wait are refused. An exception that nothing catches stops the arm.
    A Robot that neither a name nor a handle refers to ends like a closed one. One made before fork() is closed in the
    child process.
    Raises ConnectionRefused, HostUnreachable, AddressInvalid, FieldUnknown (naming the field) or Timeout.
    """

    def __init__(self, address: str, *, fields: Sequence[str] | None = None, frequency: float = 0.0,
                 speed_cap: float = 0.25, timeout: float | None = 5.0, port_offset: int = 0,
                 upper_registers: bool = True, priority: int = 85, simulator: Simulator | None = None) -> None:
        self.address = address
        self._port_offset = port_offset
        self._upper_registers = upper_registers
        self._why_closed = "the robot was closed: make another Robot"
        # No method of this object: a cycle of references would keep connection and registers alive.
        self._waiting: Callable[[], AbstractContextManager[Any]] = contextlib.nullcontext
        if simulator is not None:
            self._waiting = simulator.flowing
        clock = None if simulator is None else simulator._native.clock()
        port = 30004 + port_offset
        followed = [] if not fields else [*fields, *(field for field in _CONFIRMING if field not in fields)]
        receiver = _native.Receiver(address, port, frequency, followed, min(priority + 5, 99) if priority else 0, clock)
        controller = _native.Controller(address, port_offset, upper_registers, priority, speed_cap, clock)
        self._links: tuple[_native.Receiver, _native.Controller] | None = (receiver, controller)
        if simulator is not None:
            simulator._native.follow(receiver)
            simulator._native.follow(controller)
        self._layout: Layout = {name: (first, count) for name, first, count, _ in receiver.layout()
                                if not fields or name in fields or name == "timestamp"}
        self._last: Sample | None = None
        self._outputs: services.Outputs | None = None
        self._force_blocks: list[ForceMode] = []
        #: power, programs, the pendant
        self.dashboard = services.Dashboard(address, port_offset, self._waiting)
        receiver.start()
        try:
            with self._waiting():
                receiver.wait_for_data(timeout)
        except BaseException:
            self.close()
            raise
        _watch_exceptions()
        _open.add(self)

    @property
    def _receiver(self) -> _native.Receiver:
        return self._opened()[0]

    @property
    def _controller(self) -> _native.Controller:
        return self._opened()[1]

    def _opened(self) -> tuple[_native.Receiver, _native.Controller]:
        links = self._links
        if links is None:
            raise NotConnected(f"robot at {self.address}", self._why_closed)
        return links

    def close(self) -> None:
        """Brakes what moves, gives control back, ends the connection and frees its registers and memory.

        Harmless when it is closed. Afterwards `state` is the last packet, and everything that needs the robot raises
        NotConnected: connect again with another Robot.
        """
        if (links := self._links) is not None:
            with self._waiting():
                links[1].release()  # refused in a callback of packet_loop(): then nothing has changed
        links, self._links = self._links, None
        _open.discard(self)
        if links is None:
            return
        receiver = links[0]
        if self._outputs is not None:
            self._outputs._native.disconnect()
            self._outputs = None
        self._last = Sample(receiver.latest(), self._layout)
        receiver.stop()

    def __enter__(self) -> Robot:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        links = self._links
        if links is None:
            return f"<tiller.Robot {self.address}, closed>"
        control = "in control" if self.in_control else "not in control"
        return f"<tiller.Robot {self.address}, {links[0].state().lower()}, {control}>"

    # ---- what it sends

    @property
    def state(self) -> Sample:
        """The newest packet; the last one when the robot is closed. Its values are NaN where the robot does not send them;
        see wait_for_data(). While the link is lost, robot_mode, safety_mode and runtime_state are unknown."""
        links, last = self._links, self._last
        if links is None and last is not None:
            return last
        receiver = self._receiver
        return Sample(receiver.latest(), self._layout, receiver.state() == "Receiving")

    @property
    def data_age(self) -> float:
        """Age of the newest packet [s]; enormous when there is none, infinite when the robot is closed."""
        links = self._links
        return float("inf") if links is None else links[0].age()

    def wait_for_data(self, timeout: float | None = 5.0) -> Sample:
        """The newest packet, as soon as there is one that is not older than 100 ms. Raises why there is none."""
        with self._waiting():
            return Sample(self._receiver.wait_for_data(timeout), self._layout)

    def samples(self, timeout: float | None = 2.5) -> Samples:
        """Every packet once, from now on: `for sample in robot.samples():`. timeout: for each [s], raises Timeout.

        At 500 Hz that costs a few percent of a core.
        """
        return Samples(self._receiver.subscribe(), self._layout, timeout, self._waiting)

    def snapshot(self, *fields: str) -> tuple[Any, ...]:
        """Several fields of one packet: `q, pose = robot.snapshot("actual_q", "actual_TCP_pose")`."""
        sample = self.state
        return tuple(sample[field] for field in fields)

    def record(self, path: str | os.PathLike[str], fields: Sequence[str] = ()) -> Recording:
        """Writes one row for each packet from now on; see Recording. The end of the name chooses the format: .csv or .mcap.
        A file of that name is replaced. fields: which of those that are followed; none named: all.

        Raises InvalidArgument for another end of the name, FieldUnknown naming each field that is not followed,
        FileNotWritable (also for a file that another recording is writing), DiskFull."""
        name = os.fspath(path)
        recording = Recording(_native.Recorder(self._receiver, name, list(fields or self._layout)), name)
        _recordings.add(recording)
        return recording

    @property
    def version(self) -> tuple[int, int, int, int]:
        """Of the controller's software."""
        return self._receiver.version()

    @property
    def link(self) -> Mapping[str, Any]:
        """A dict: counts of packets, late and lost ones and reconnects, and the rate [Hz]."""
        return self._receiver.counters()

    # ---- control

    def take_control(self, timeout: float | None = 10.0) -> Robot:
        """Uploads the control program; ends the program that runs on the robot. Does nothing when in control.

        An earlier Robot object of this program that controls the same robot and moves nothing gives control up, as when a
        notebook cell runs again. Raises RegisterInUse when that one has a motion or force mode under way;
        RemoteControlRequired, UnsafeState, NotConnected (after close()) and the like, each with what to do.
        """
        controller = self._controller
        for other in list(_open):
            links = other._links
            if links is None or other is self or not self._shares_registers(other) or not links[1].status()["in_control"]:
                continue
            if links[1].is_busy():
                raise RegisterInUse(f"take control of {self.address}",
                                    "another Robot object of this program moves the arm: stop() or close() that one first")
            with other._waiting():
                links[1].release()
        with self._waiting():
            controller.take_control(timeout)
        return self

    def _shares_registers(self, other: Robot) -> bool:
        return (self.address, self._port_offset, self._upper_registers) == (other.address, other._port_offset,
                                                                           other._upper_registers)

    def release(self) -> None:
        """Brakes what moves and gives control back; data go on coming."""
        with self._waiting():
            self._controller.release()

    @property
    def in_control(self) -> bool:
        """Whether motions can be commanded; False when the robot is closed."""
        links = self._links
        return links is not None and bool(links[1].status()["in_control"])

    @property
    def status(self) -> Mapping[str, Any]:
        """What control knows, a dict: "in_control", "loss" (why not), "fresh" (False: no data for 100 ms, so the modes are
        unknown and the rest describes the past), "moving", "executing", "limiter" (what holds the speed
        down), "last_cause" (why the last motion ended, as Move.cause), "last_stop_ms" and "last_stop_mm", "round_trip_ms",
        "robot_mode", "safety_mode", "speed_fraction", "speed_scaling" and more."""
        return self._controller.status()

    @property
    def speed_cap(self) -> float:
        """No command makes TCP or elbow faster than this [m/s]. Setting it ends what moves."""
        return self._controller.speed_cap()

    @speed_cap.setter
    def speed_cap(self, metres_per_second: float) -> None:
        self._controller.set_speed_cap(metres_per_second)

    def stop(self) -> None:
        """Ends whatever moves, at once; nothing commanded before moves the arm after it. Not an emergency stop."""
        self._controller.stop()

    # ---- moves: they go on without their handles
    # All raise at once: InvalidArgument, LimitExceeded, NoSolution (out of reach), NotInControl, UnsafeState, LinkLost,
    # Stopped; what goes wrong on the way is raised by Move.wait().

    def move_j(self, q: Floats, speed: float = 1.05, acceleration: float = 1.4, silence: float = 0.1) -> Move:
        """Linear in joint space to joint positions [rad]; speed [rad/s], acceleration [rad/s2] of the leading joint. The
        speed cap binds it too: Move.plan says what speed is left and how long the move takes. A Pose is refused.

        Returns at once; the arm moves to its target whether or not the handle is kept. See Move for what ends it.
        silence: 0.1 ... 4 [s]; the move goes on when this computer falls silent for no longer than that (a busy machine, a
        cable plugged in again). For that time the arm moves unattended; after it the robot ends the move by itself.
        """
        return self._move(self._controller.move_j(joint_positions(q, "q", "move_j_to_pose()"), speed, acceleration, silence))

    def move_j_to_pose(self, pose: Floats, speed: float = 1.05, acceleration: float = 1.4, silence: float = 0.1) -> Move:
        """Linear in joint space to a pose of the TCP in the base frame [m, rad]; speed [rad/s], acceleration [rad/s2];
        silence as in move_j(). Joints are refused."""
        return self._move(self._controller.move_j_to_pose(pose_numbers(pose, "pose", "move_j()"), speed, acceleration,
                                                          silence))

    def move_l(self, pose: Floats, speed: float | None = None, acceleration: float = 1.2, silence: float = 0.1) -> Move:
        """A straight line of the TCP to a pose in the base frame [m, rad]; speed [m/s], None: 0.25, or the cap where that
        is lower; acceleration [m/s2]; silence as in move_j(). Joints are refused. Raises NoSolution when the arm cannot
        reach it, LimitExceeded for a speed above the cap."""
        return self._move(self._controller.move_l(pose_numbers(pose, "pose", "move_l_to_joints()"), speed, acceleration,
                                                  silence))

    def move_l_to_joints(self, q: Floats, speed: float | None = None, acceleration: float = 1.2,
                         silence: float = 0.1) -> Move:
        """A straight line of the TCP to the pose that joint positions [rad] give; otherwise as move_l()."""
        return self._move(self._controller.move_l_to_joints(joint_positions(q, "q", "move_l()"), speed, acceleration, silence))

    def move_path(self, path: Sequence[PathMove], timeout: float | None = 5.0, silence: float = 0.1) -> Move:
        """Follows moves one after the other; timeout: for the start [s]; silence as in move_j(). The arm must not
        be moving."""
        with self._waiting():
            return self._move(self._controller.move_path([move.row() for move in path], timeout, silence))

    def move_until_contact(self, velocity: Floats, direction: Floats = ZEROS, acceleration: float = 0.5,
                           timeout: float | None = 5.0) -> Move:
        """Moves the tool [m/s, rad/s] until it touches something, then back to where the contact began.

        direction: from which contact is looked for, in the base frame; zeros: any. timeout: for the start [s].
        """
        with self._waiting():
            return self._move(self._controller.move_until_contact(floats(velocity, "velocity"),
                                                                  floats(direction, "direction"), acceleration, timeout))

    def stop_j(self, deceleration: float = 4.0) -> Move:
        """Brakes with this deceleration of the leading joint [rad/s2]; wait() returns when the arm is at standstill."""
        return self._move(self._controller.stop_j(deceleration))

    def stop_l(self, deceleration: float = 2.0) -> Move:
        """Brakes with this deceleration of the tool [m/s2]; wait() returns when the arm is at standstill."""
        return self._move(self._controller.stop_l(deceleration))

    def freedrive(self) -> Move:
        """The arm follows the hand until the handle is cancelled, the robot is stopped or another motion begins."""
        return self._move(self._controller.freedrive())

    def run_function(self, body: str, name: str = "function", timeout: float | None = 5.0) -> Move:
        """Runs lines of URScript, without def and end, under the control program: stops hold for it too.

        Raises InvalidArgument for an `end` that closes no block of the body, ScriptError with line and text. timeout: for the
        start [s]; the handle is done when the function returns.
        """
        with self._waiting():
            return self._move(self._controller.start_function(name, body, timeout))

    def run_script(self, program: str, timeout: float | None = None, *, unattended: bool = False) -> None:
        """Runs a whole URScript program in place of the control program, waits for its end [s] and takes control again.

        program: `def ... end`, or lines, which run one after the other; names beginning with tiller_heartbeat are reserved.
        A watchdog thread, sent in the program, ends it and brakes the arm when this process ends, is killed or loses the
        link for 100 ms. unattended: True sends the program as it is. Then the arm moves on after this process has ended,
        until the program is done, and only the pendant or another client can stop it.
        Raises ScriptError with line and text.
        """
        with self._waiting():
            self._controller.run_script(program, timeout, unattended)

    def _handle_waits(self) -> AbstractContextManager[Any]:
        """For handles. This method keeps the Robot open while they exist, so that an uncaught exception and take_control()
        of another Robot find what moves."""
        return self._waiting()

    def _move(self, native: _native.Motion) -> Move:
        return Move(native, self._handle_waits)

    # ---- streams, jogs, loops

    def servo_j(self, lookahead: float = 0.1, gain: float = 300.0) -> Stream:
        """A stream of joint positions [rad], sent one a cycle. lookahead 0.03 ... 0.2 [s], gain 100 ... 2000."""
        return Stream(self._controller.servo_j(lookahead, gain), self._handle_waits, joint_positions)

    def servo_l(self, lookahead: float = 0.1, gain: float = 300.0) -> Stream:
        """A stream of TCP poses in the base frame [m, rad], sent one a cycle."""
        return Stream(self._controller.servo_l(lookahead, gain), self._handle_waits, pose_numbers)

    def speed_j(self, acceleration: float = 0.5) -> Stream:
        """A stream of joint velocities [rad/s]; acceleration [rad/s2]."""
        return Stream(self._controller.speed_j(acceleration), self._handle_waits, floats)

    def speed_l(self, acceleration: float = 0.5) -> Stream:
        """A stream of tool speeds in the base frame [m/s, rad/s]; acceleration [m/s2]."""
        return Stream(self._controller.speed_l(acceleration), self._handle_waits, floats)

    def torque(self, viscous_scale: Floats | None = None, coulomb_scale: Floats | None = None) -> Stream:
        """A stream of joint torques [Nm], sent one a cycle; gravity is not part of them, the controller holds the arm.

        viscous_scale, coulomb_scale: how much of each joint's friction the controller makes up for, 0 ... 1; None: as it
        has it. Until the first torques are sent the arm holds its place. The stream ends with the cause "LimitReached"
        when TCP or elbow get faster than the cap on their speed: a torque cannot be slowed down. However it ends, torques
        against the motion slow the arm down first, for 0.1 s at most. Raises VersionUnsupported before PolyScope 5.25.1
        and 10.12.1, and send() LimitExceeded above what a joint can give.
        """
        viscous = None if viscous_scale is None else floats(viscous_scale, "viscous_scale")
        coulomb = None if coulomb_scale is None else floats(coulomb_scale, "coulomb_scale")
        return Stream(self._controller.torque(viscous, coulomb), self._handle_waits, floats)

    def jog(self, velocity: Floats, frame: str = "base", *, custom_frame: Floats = ZEROS,
            contact_force: float = 0.0) -> Jog:
        """Jogs with a tool velocity [m/s, rad/s], in frame "joints" with joint velocities [rad/s].

        frame: "base", "tool", "custom" (axes of custom_frame, a pose in the base frame) or "joints". contact_force: above
        0: ends when the force on the TCP has changed by more than this [N]. Refresh it at least every 100 ms.
        """
        one_of(frame, "frame", JOG_FRAMES)
        axes = pose_numbers(custom_frame, "custom_frame")
        native = self._controller.jog(frame, floats(velocity, "velocity"), axes, contact_force)
        return Jog(native, frame, axes, contact_force, self._handle_waits)

    def jog_while(self, callback: Callable[[Sample], Floats | None], frame: str = "base", period: float = 0.02) -> None:
        """Jogs with the velocity the callback returns, asked every `period` [s], until it returns None.

        An exception in the callback brakes the arm and is raised here. Each call costs some 50 us and needs the
        interpreter: a callback that keeps it for 100 ms, or a thread that does, ends the jog.
        """
        first = callback(self.state)
        if first is None:
            return
        with self._waiting(), self.jog(first, frame) as jog:
            while (velocity := callback(self.state)) is not None and jog.refresh(velocity):
                time.sleep(period)

    def packet_loop(self, kind: str, callback: Callable[[Mapping[str, Any]], Floats | None], *,
                    timeout: float | None = None, at_once: bool = False) -> LoopReport:
        """Calls back once for each packet, in step with the robot; what the callback returns goes out with the answer to
        that very packet. None ends the loop: the arm brakes, and may still do so for some 0.1 s when this returns. The
        choice for everything that has to be on time; servo_j() and its like are for targets that come when they come.

        kind: "servo_j" (joint positions [rad]), "servo_l" (TCP poses [m, rad]), "speed_j" [rad/s], "speed_l" [m/s, rad/s]
        or "torque" [Nm]. The callback gets a dict: cycle (from 0), time since the loop began [s], period [s], age (of the
        values when the call began, by the robot's time stamps [s]), fresh (False: the packet did not come and the values
        are the last ones, or age is above two periods), missed (periods without a call since the loop began), q, qd,
        tcp_pose, tcp_speed, speed_fraction, speed_scaling. timeout: of the whole loop [s], raises Timeout. at_once: send
        each target as soon as it is there rather than at even distances.
        Each call takes some 30 us besides the callback's own time, and waits for the interpreter: other Python threads
        hold it for up to 5 ms at a time (sys.setswitchinterval). After a call that took longer than a period the next one
        gets the newest packet. While a call runs no heartbeat is sent: one that takes 100 ms stops the arm and raises
        Stopped with the measured time. An exception in it brakes the arm and is raised here; so does Ctrl-C. A blocking
        call inside the callback, another packet_loop() included, raises InvalidArgument: nothing could end its wait.
        """
        one_of(kind, "kind", _LOOP_TARGETS)
        check, meaning = _LOOP_TARGETS[kind]

        def checked(cycle: dict[str, Any]) -> list[float] | None:
            cycle["q"] = cycle["q"].view(Joints)
            cycle["tcp_pose"] = cycle["tcp_pose"].view(Pose)
            target = callback(cycle)
            return None if target is None else check(target, f"the callback's target ({meaning})")

        with self._waiting():
            return LoopReport(**self._controller.packet_loop(kind, checked, at_once, timeout))

    # ---- questions and settings

    def inverse_kinematics(self, pose: Floats, near: Floats | None = None, timeout: float | None = 1.0) -> Joints:
        """Joint positions [rad] for a pose of the TCP [m, rad], by the robot's own calibration. Raises NoSolution."""
        with self._waiting():
            return Joints(self._controller.inverse_kinematics(pose_numbers(pose, "pose"), None if near is None
                                                              else joint_positions(near, "near"), timeout))

    def forward_kinematics(self, q: Floats, timeout: float | None = 1.0) -> Pose:
        """Pose of the TCP [m, rad] for joint positions [rad], by the robot's own calibration."""
        with self._waiting():
            return Pose(self._controller.forward_kinematics(joint_positions(q, "q"), timeout))

    def set_payload(self, mass: float, centre_of_gravity: Floats | None = None, timeout: float | None = 1.0) -> None:
        """Mass [kg] and centre of gravity from the flange [m]; without one it stays as it is."""
        cog = None if centre_of_gravity is None else floats(centre_of_gravity, "centre_of_gravity", 3)
        with self._waiting():
            self._controller.set_payload(mass, cog, timeout)

    def set_tcp(self, tcp: Floats, timeout: float | None = 1.0) -> None:
        """The TCP as a pose in the flange frame [m, rad]."""
        with self._waiting():
            self._controller.set_tcp(pose_numbers(tcp, "tcp"), timeout)

    def zero_force_sensor(self, timeout: float | None = 1.0) -> None:
        """Takes what the force sensor measures now as zero."""
        with self._waiting():
            self._controller.zero_force_sensor(timeout)

    def force_mode(self, compliant: Sequence[bool], wrench: Floats, limits: Floats, *, frame: Floats = ZEROS,
                   kind: int = 2, timeout: float | None = 1.0) -> ForceMode:
        """Makes the arm compliant from now on; motions may run meanwhile. Use it in a `with` block, or see ForceMode for
        what else ends it.

        compliant: per axis of the frame. wrench: wanted on those [N, Nm]. limits: highest speeds of compliant axes [m/s,
        rad/s], largest deviation of the others [m, rad]. frame: a pose in the base frame. kind: 1, 2 or 3, how the force
        frame follows from it. timeout: for the robot's confirmation, at the beginning and at the end [s].
        """
        axes = [bool(one_of(axis, "compliant", (0.0, 1.0))) for axis in floats(compliant, "compliant")]
        numbers, largest, task = floats(wrench, "wrench"), floats(limits, "limits"), pose_numbers(frame, "frame")
        one_of(kind, "kind", (1, 2, 3))
        controller, waiting = self._controller, self._handle_waits

        def begin(stops: int) -> None:
            with waiting():
                controller.force_mode(task, axes, numbers, kind, largest, stops, timeout)

        def end() -> None:
            with waiting():
                controller.end_force_mode(timeout)

        return ForceMode(self._force_blocks, controller.stops, begin, end)

    def end_force_mode(self, timeout: float | None = 1.0) -> None:
        """Ends force mode, whichever call began it. Harmless when it is off."""
        with self._waiting():
            self._controller.end_force_mode(timeout)

    @property
    def outputs(self) -> services.Outputs:
        """Digital and analog outputs and the speed slider, through a connection of their own."""
        receiver = self._receiver
        if self._outputs is None:
            native = _native.Outputs(receiver, self.address, 30004 + self._port_offset)
            self._outputs = services.Outputs(native, self._waiting)
        return self._outputs

    def registers(self, ints: Sequence[int] = (), doubles: Sequence[int] = (), bits: Sequence[int] = (),
                  timeout: float | None = 3.0) -> services.Registers:
        """Input registers this program wants to write, by number: integers and doubles 0-47, bits 64-127; the control
        program uses integers 24-33 and doubles 24-41. Raises InvalidArgument for other numbers; RegisterInUse when another
        client or a fieldbus owns one."""
        self._opened()
        return services.registers(self.address, 30004 + self._port_offset, ints, doubles, bits, timeout, self._waiting)

    def recover(self, consent: services.Consent, timeout: float | None = 60.0,
                progress: Callable[[str], None] | None = None) -> None:
        """Leads the robot back to RUNNING in NORMAL, one step after the other, as far as a person consented.

        progress: called with the name of each step. Raises Rejected with what is missing when a step needs a consent that
        was not given, or a person at the robot.
        """
        self._opened()
        with self._waiting():
            _native.recover(self.address, self._port_offset, consent.cause_inspected, consent.restart_safety,
                            consent.power_on, consent.release_brakes, progress, timeout)
