# SPDX-License-Identifier: MIT
"""A connection to one robot: its data, its motions and its services."""
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
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Literal

from . import _native, arm, services, simulator as simulators
from ._arguments import checked
from ._values import ZEROS, Array, Floats, Joints, Pose, floats, joint_positions, one_of, pose_numbers
from .collision import CollisionCheck
from .errors import Error, NotConnected, RegisterInUse
from .modes import ControlLoss, LimiterKind, RobotMode, SafetyMode, StopCause
from .motions import ForceMode, Jog, Move, PathMove, Stream
from .receive import SILENT, Condition, Layout, Recording, Sample, Samples
from .simulator import Simulator

# Reported states of the outputs, received in addition to the requested fields.
_CONFIRMING = ("actual_digital_output_bits", "target_speed_fraction", "analog_io_types", "standard_analog_output0",
               "standard_analog_output1")
JogFrame = Literal["base", "tool", "custom", "joints"]
JOG_FRAMES: tuple[JogFrame, ...] = ("base", "tool", "custom", "joints")
LoopKind = Literal["servo_j", "servo_l", "speed_j", "speed_l", "torque"]
_LOOP_TARGETS: dict[LoopKind, tuple[Callable[[Floats, str], list[float]], str]] = {
    "servo_j": (joint_positions, "joint positions"), "servo_l": (pose_numbers, "a pose"), "speed_j": (floats, "joint speeds"),
    "speed_l": (floats, "a tool speed"), "torque": (floats, "joint torques")}

_open: weakref.WeakSet[Robot] = weakref.WeakSet()
_recordings: weakref.WeakSet[Recording] = weakref.WeakSet()


@atexit.register
def _end_of_process() -> None:
    """Called at interpreter shutdown. The remaining threads are daemons and must not run Python code again."""
    _native.park_other_threads()
    for recording in list(_recordings):
        with contextlib.suppress(Error):
            recording.stop()
    for robot in list(_open):
        robot.close()
    simulators.stop_all()


def _in_forked_child() -> None:
    """Threads and connections belong to the parent process: the child discards its copies without closing them."""
    _native.forget_parent()
    for robot in list(_open):
        robot._links = None
        robot._why_closed = "this Robot was created before fork(): create another one in the child process"
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
    """An uncaught exception stops the arm immediately: in the main thread, in other threads, and in a notebook cell."""
    earlier, earlier_in_threads = sys.excepthook, threading.excepthook

    def uncaught(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        _brake_all()
        earlier(kind, error, trace)

    def uncaught_in_thread(arguments: threading.ExceptHookArgs) -> None:
        if arguments.exc_type is not SystemExit:
            _brake_all()
        earlier_in_threads(arguments)

    sys.excepthook, threading.excepthook = uncaught, uncaught_in_thread
    # IPython and Jupyter do not call these hooks.
    shell = getattr(builtins, "get_ipython", lambda: None)()
    if shell is not None:
        def after_cell(result: Any) -> None:
            if not result.success:
                _brake_all()

        shell.events.register("post_run_cell", after_cell)


@dataclass(frozen=True)
class LoopReport:
    """Statistics of a packet loop.

    cycles: calls of the callback. missed: control periods without a call. stale: cycles that ran in time but without a
    new packet; the callback received the previous values. late: cycles that began more than half a period late.
    overruns: calls that took longer than a period. longest_call [s]. longest_wait: maximum time that a call waited
    for other Python threads (the interpreter lock), included in its duration [s]. fast_wake_ups: the system kept its
    processors out of deep sleep. A few stale or late cycles are normal on a busy machine; many missed cycles make the
    motion rough.
    """

    cycles: int
    missed: int  #: control periods without a cycle
    stale: int  #: cycles that ran in time without a new packet
    late: int  #: cycles that began more than half a period late
    overruns: int  #: calls that took longer than a period
    longest_call: float  #: [s]
    longest_wait: float = 0.0  #: maximum wait of a call for the interpreter lock [s]
    fast_wake_ups: bool = False  #: the system kept its processors out of deep sleep


@dataclass
class Cycle:
    """Argument of the callback of packet_loop()."""

    cycle: int  #: number of the call, from 0
    time: float  #: since the start of the loop [s]
    period: float  #: control period [s]
    age: float  #: age of the values at the start of the call, from the robot's timestamps [s]
    fresh: bool  #: False: no new packet arrived, so the values are those of the previous packet, or age exceeds two periods
    missed: int  #: periods without a call since the start
    q: Joints  #: actual joint positions [rad]
    qd: Array  #: actual joint velocities [rad/s]
    tcp_pose: Pose  #: actual pose of the TCP in the base frame [m, rad]
    tcp_speed: Array  #: actual speed of the TCP in the base frame [m/s, rad/s]
    speed_fraction: float  #: the speed slider, 0 ... 1
    speed_scaling: float  #: reduction by the controller's own limits, 0 ... 1
    packet: Sample  #: all values of this packet, e.g. tcp_force and the fields requested by Robot(fields=[...])


@dataclass(frozen=True)
class ControlStatus:
    """The state of control."""

    in_control: bool  #: motions can be commanded
    loss: ControlLoss  #: why motions cannot be commanded; NONE while in control
    fresh: bool  #: False: no data for 100 ms, so the modes are unknown and the other values are outdated
    robot_mode: RobotMode
    safety_mode: SafetyMode
    moving: bool  #: measured from the received data
    force_mode: bool  #: force mode is permitted, and active if a client has started it
    executing: bool  #: the robot has confirmed the execution of the active motion
    limiter: LimiterKind  #: limit that reduces the speed
    limiter_joint: int  #: limiting joint 0-5; -1: no joint
    limiter_scale: float  #: factor applied to the requested speed, 0 ... 1
    last_cause: StopCause  #: cause of the end of the last motion
    last_stop_ms: float  #: measured duration of the last stop [ms]
    last_stop_mm: float  #: measured distance of the last stop [mm]
    round_trip_ms: float  #: from a command to its echo [ms]; 0: not known yet
    speed_fraction: float  #: the speed slider, 0 ... 1
    speed_scaling: float  #: reduction by the controller's own limits, 0 ... 1


@dataclass(frozen=True)
class LinkCounters:
    """Packets received since the start of the connection."""

    packets: int
    late: int  #: packets more than half a period late
    lost: int
    reconnects: int
    rate: float  #: [packets/s]


@checked
class Robot:
    """A connection to a robot.

        with tiller.Robot("192.168.0.10") as robot:
            print(robot.state.tcp_pose)
            robot.take_control()
            robot.move_j(robot.state.q + [0.1, 0, 0, 0, 0, 0]).wait()

    Data are received immediately; take_control() takes control. A refused connection is not retried.
    address: address of the controller. fields: RTDE outputs to receive, also in the packets of packet_loop(); None: a
    default selection. frequency: packets per second [Hz]; 0: maximum of the controller. speed_cap: maximum speed of the TCP and
    the elbow for all commands, including moves [m/s]. timeout: for the first packet [s]. upper_registers: use registers
    24-47 instead of 0-23. priority: priority of the receive and control threads; 0: normal.
    All methods may be called from any thread and let other Python threads run while they wait; Ctrl+C ends every wait.
    Methods that wait are refused only in a callback of packet_loop(). An uncaught exception stops the arm.
    A Robot is closed when neither a variable nor a handle refers to it. After fork() it is closed in the child process.
    Raises ConnectionRefused, HostUnreachable, AddressInvalid, FieldUnknown (naming the field) or Timeout.
    """

    def __init__(self, address: str, *, fields: Sequence[str] | None = None, frequency: float = 0.0,
                 speed_cap: float = 0.25, timeout: float | None = 5.0, port_offset: int = 0,
                 upper_registers: bool = True, priority: int = 85, simulator: Simulator | None = None) -> None:
        self.address = address
        self._port_offset = port_offset
        self._upper_registers = upper_registers
        self._why_closed = "the robot was closed: create another Robot"
        # Do not store a bound method, because a reference cycle would keep the connection and the registers in
        # use.
        self._waiting: Callable[[], AbstractContextManager[Any]] = contextlib.nullcontext
        if simulator is not None:
            self._waiting = simulator.flowing
        self._simulator = simulator
        clock = None if simulator is None else simulator._native.clock()
        port = 30004 + port_offset
        followed = [] if not fields else [*fields, *(field for field in _CONFIRMING if field not in fields)]
        receiver = _native.Receiver(address, port, frequency, followed, min(priority + 5, 99) if priority else 0, clock)
        controller = _native.Controller(address, port_offset, upper_registers, priority, speed_cap, clock,
                                        list(fields or ()))
        self._links: tuple[_native.Receiver, _native.Controller] | None = (receiver, controller)
        if simulator is not None:
            simulator._native.follow(receiver)
            simulator._native.follow(controller)
        self._layout: Layout = {name: (first, count) for name, first, count, _ in receiver.layout()
                                if not fields or name in fields or name == "timestamp"}
        self._last: Sample | None = None
        self._outputs: services.Outputs | None = None
        self._force_blocks: list[ForceMode] = []
        #: power, programs, the teach pendant
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
        """Stops the arm, releases control, closes the connection and frees its registers and memory.

        No effect if already closed. Afterwards `state` is the last packet, and everything that needs the robot raises
        NotConnected: create another Robot to connect again.
        """
        if (links := self._links) is not None:
            with self._waiting():
                links[1].release()  # refused in a callback of packet_loop(), before anything has changed
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

    # ---- data

    @property
    def state(self) -> Sample:
        """The newest packet; after close(), the last packet received. Values that the robot does not send are NaN;
        see wait_for_data(). While the link is lost, robot_mode, safety_mode and runtime_state are unknown."""
        links, last = self._links, self._last
        if links is None and last is not None:
            return last
        receiver = self._receiver
        return Sample(receiver.latest(), self._layout, receiver.state() == "Receiving")

    @property
    def data_age(self) -> float:
        """Age of the newest packet [s]; very large if there is none, infinite after close()."""
        links = self._links
        return float("inf") if links is None else links[0].age()

    def wait_for_data(self, timeout: float | None = 5.0) -> Sample:
        """Waits for a packet that is at most 100 ms old. Raises an error with the reason if none arrives in time."""
        with self._waiting():
            return Sample(self._receiver.wait_for_data(timeout), self._layout)

    def samples(self, timeout: float | None = SILENT) -> Samples:
        """Iterates over every packet from now on: `for sample in robot.samples():`, or `async for` in a coroutine.
        timeout: for each packet [s]; raises Timeout.

        At 500 Hz, this uses a few percent of a CPU core.
        """
        return Samples(self._receiver.subscribe(), self._layout, timeout, self._waiting)

    def until(self, condition: Callable[[Sample], Any]) -> Condition:
        """Returns a Condition that is met when `condition(sample)` is true:

            robot.until(lambda sample: sample.digital_input(3)).wait(timeout=10)
            sample = await robot.until(lambda sample: sample.tcp_force[2] > 20)

        Checks the newest packet and then every new packet. Waiting does not affect motions.
        """
        samples = self.samples()
        return Condition(samples, self.state, condition)

    def snapshot(self, *fields: str) -> tuple[Any, ...]:
        """Returns several fields of one packet: `q, pose = robot.snapshot("actual_q", "actual_TCP_pose")`."""
        sample = self.state
        return tuple(sample[field] for field in fields)

    def record(self, path: str | os.PathLike[str], fields: Sequence[str] = ()) -> Recording:
        """Records every packet from now on, one row per packet; see Recording. The extension of the name selects the
        format: .csv or .mcap. An existing file is replaced. fields: a selection of the received fields; empty: all.

        Raises InvalidArgument for any other extension, FieldUnknown (lists the fields that are not received),
        FileNotWritable (also for a file in use by another recording), DiskFull.
        """
        name = os.fspath(path)
        recording = Recording(_native.Recorder(self._receiver, name, list(fields)), name)
        _recordings.add(recording)
        return recording

    @property
    def version(self) -> tuple[int, int, int, int]:
        """Version of the controller software."""
        return self._receiver.version()

    @property
    def link(self) -> LinkCounters:
        """Numbers of received, late and lost packets and of reconnects, and the packet rate."""
        return LinkCounters(**self._receiver.counters())

    # ---- control

    def take_control(self, timeout: float | None = 10.0) -> Robot:
        """Uploads the control program, which ends any program running on the robot. Returns immediately if already in
        control.

        An earlier Robot object in this process that controls the same robot without a motion releases control, e.g.
        when a notebook cell is run again. Raises RegisterInUse if that object has an active motion or force mode;
        RemoteControlRequired, UnsafeState, NotConnected (after close()) and others, each with a suggested action.
        """
        controller = self._controller
        for other in list(_open):
            links = other._links
            if links is None or other is self or not self._shares_registers(other) or not links[1].status()["in_control"]:
                continue
            if links[1].is_busy():
                raise RegisterInUse(f"take control of {self.address}",
                                    "another Robot object of this program is moving the arm: call its stop() or close() first")
            with other._waiting():
                links[1].release()
        with self._waiting():
            controller.take_control(timeout)
        return self

    def _shares_registers(self, other: Robot) -> bool:
        return (self.address, self._port_offset, self._upper_registers) == (other.address, other._port_offset,
                                                                           other._upper_registers)

    def release(self) -> None:
        """Stops the arm and releases control; data are still received."""
        with self._waiting():
            self._controller.release()

    @property
    def in_control(self) -> bool:
        """True if motions can be commanded; False after close()."""
        links = self._links
        return links is not None and bool(links[1].status()["in_control"])

    @property
    def status(self) -> ControlStatus:
        """The state of control."""
        values = self._controller.status()
        for name, kind in (("loss", ControlLoss), ("robot_mode", RobotMode), ("safety_mode", SafetyMode),
                           ("limiter", LimiterKind), ("last_cause", StopCause)):
            values[name] = kind(values[name])
        return ControlStatus(**values)

    @property
    def speed_cap(self) -> float:
        """Speed limit of the TCP and the elbow for all commands [m/s]. Changing it ends the active motion."""
        return self._controller.speed_cap()

    @speed_cap.setter
    def speed_cap(self, metres_per_second: float) -> None:
        self._controller.set_speed_cap(metres_per_second)

    def set_collision_check(self, check: CollisionCheck | None) -> None:
        """Sets the collision check for jogs, which slow down and end at its safety distance; None: no check. Moves, paths
        and streams are not checked: use CollisionCheck.examine() before a move."""
        _native.set_collision_check(self._controller, None if check is None else check._native)

    def stop(self) -> None:
        """Ends the active motion immediately; no earlier command can move the arm afterwards. Not an emergency stop."""
        self._controller.stop()

    # ---- moves: they continue without their handles
    # All raise immediately: InvalidArgument, LimitExceeded, NoSolution (unreachable), NotInControl, UnsafeState,
    # LinkLost, Stopped; later errors are raised by Move.wait().

    def move_j(self, q: Floats, speed: float = 1.05, acceleration: float = 1.4, heartbeat_timeout: float = 0.1) -> Move:
        """Moves linearly in joint space to joint positions [rad]; speed [rad/s] and acceleration [rad/s2] of the
        leading joint. The speed cap also applies: Move.plan contains the resulting speed and the duration. A Pose
        is refused.

        Returns immediately; the arm moves to its target even if the handle is discarded. See Move for what ends a
        motion.
        heartbeat_timeout: 0.1 ... 4 [s]: the move continues for this time without a heartbeat from this computer, e.g.
        while the machine is busy or a cable is replugged. During this time, the arm moves unattended; then the robot
        ends the move.
        """
        return self._move(self._controller.move_j(joint_positions(q, "q", "move_j_to_pose()"), speed, acceleration,
                                                  heartbeat_timeout))

    def move_j_to_pose(self, pose: Floats, speed: float = 1.05, acceleration: float = 1.4,
                       heartbeat_timeout: float = 0.1) -> Move:
        """Moves linearly in joint space to a pose of the TCP in the base frame [m, rad]; speed [rad/s], acceleration
        [rad/s2]; heartbeat_timeout as in move_j(). Joints are refused."""
        return self._move(self._controller.move_j_to_pose(pose_numbers(pose, "pose", "move_j()"), speed, acceleration,
                                                          heartbeat_timeout))

    def move_l(self, pose: Floats, speed: float | None = None, acceleration: float = 1.2,
               heartbeat_timeout: float = 0.1) -> Move:
        """Moves the TCP on a straight line to a pose in the base frame [m, rad]; speed [m/s], None: 0.25, or the cap if
        lower; acceleration [m/s2]; heartbeat_timeout as in move_j(). Joints are refused. Raises NoSolution if the pose is
        unreachable, LimitExceeded for a speed above the cap."""
        return self._move(self._controller.move_l(pose_numbers(pose, "pose", "move_l_to_joints()"), speed, acceleration,
                                                  heartbeat_timeout))

    def move_l_to_joints(self, q: Floats, speed: float | None = None, acceleration: float = 1.2,
                         heartbeat_timeout: float = 0.1) -> Move:
        """Moves the TCP on a straight line to the pose of these joint positions [rad]; otherwise like move_l()."""
        return self._move(self._controller.move_l_to_joints(joint_positions(q, "q", "move_l()"), speed, acceleration,
                                                            heartbeat_timeout))

    def move_path(self, path: Sequence[PathMove], timeout: float | None = 5.0, heartbeat_timeout: float = 0.1) -> Move:
        """Executes moves as one path; timeout: for the start [s]; heartbeat_timeout as in move_j(). The arm must be at
        standstill."""
        with self._waiting():
            return self._move(self._controller.move_path([move.row() for move in path], timeout, heartbeat_timeout))

    def move_until_contact(self, velocity: Floats, direction: Floats = ZEROS, acceleration: float = 0.5,
                           timeout: float | None = 5.0) -> Move:
        """Moves the tool [m/s, rad/s] until contact, then back to the pose of the first contact.

        direction: direction of the contact in the base frame; zeros: any direction. timeout: for the start [s].
        """
        with self._waiting():
            return self._move(self._controller.move_until_contact(floats(velocity, "velocity"),
                                                                  floats(direction, "direction"), acceleration, timeout))

    def stop_j(self, deceleration: float = 4.0) -> Move:
        """Stops with the given deceleration of the leading joint [rad/s2]; wait() returns at standstill."""
        return self._move(self._controller.stop_j(deceleration))

    def stop_l(self, deceleration: float = 2.0) -> Move:
        """Stops with the given deceleration of the tool [m/s2]; wait() returns at standstill."""
        return self._move(self._controller.stop_l(deceleration))

    def freedrive(self) -> Move:
        """Lets a person move the arm by hand until the handle is cancelled, the robot is stopped or another motion
        starts."""
        return self._move(self._controller.freedrive())

    def run_function(self, body: str, name: str = "function", timeout: float | None = 5.0) -> Move:
        """Runs lines of URScript, without def and end, inside the control program. It can be stopped like a motion.

        Raises InvalidArgument for an `end` that does not close a block of the body, ScriptError with line and text.
        timeout: for the start [s]; the handle completes when the function returns.
        """
        with self._waiting():
            return self._move(self._controller.start_function(name, body, timeout))

    def run_script(self, program: str, timeout: float | None = None, *, unattended: bool = False) -> None:
        """Runs a complete URScript program instead of the control program, waits for its end and takes control again.

        program: `def ... end`, or a sequence of lines; names starting with tiller_heartbeat are reserved. An inserted
        watchdog thread ends the program and stops the arm if this process ends, is killed or loses the connection for
        100 ms. timeout: for the whole run [s]. unattended: True sends the program unchanged. The arm then continues to
        move after the end of this process until the program is complete, and only the teach pendant or another client can
        stop it.
        Raises ScriptError with line and text.
        """
        with self._waiting():
            self._controller.run_script(program, timeout, unattended)

    def _handle_waits(self) -> AbstractContextManager[Any]:
        """Passed to the handles. The bound method keeps the Robot alive, so that an uncaught exception and
        take_control() of another Robot find the active motion."""
        return self._waiting()

    def _receiver_of(self, fields: Sequence[str], timeout: float | None) -> _native.Receiver:
        """An additional receiver that has received data. The caller must let virtual time advance."""
        simulator = self._simulator
        clock = None if simulator is None else simulator._native.clock()
        receiver = _native.Receiver(self.address, 30004 + self._port_offset, 0.0, list(fields), 0, clock)
        if simulator is not None:
            simulator._native.follow(receiver)
        receiver.start()
        receiver.wait_for_data(timeout)
        return receiver

    def _move(self, native: _native.Motion) -> Move:
        return Move(native, self._handle_waits)

    # ---- streams, jogs, loops

    def servo_j(self, lookahead: float = 0.1, gain: float = 300.0) -> Stream:
        """Starts a stream of joint positions [rad], one per cycle. lookahead 0.03 ... 0.2 [s], gain 100 ... 2000."""
        return Stream(self._controller.servo_j(lookahead, gain), self._handle_waits, joint_positions)

    def servo_l(self, lookahead: float = 0.1, gain: float = 300.0) -> Stream:
        """Starts a stream of TCP poses in the base frame [m, rad], one per cycle."""
        return Stream(self._controller.servo_l(lookahead, gain), self._handle_waits, pose_numbers)

    def servo_c(self, speed: float = 0.25, acceleration: float = 1.2, blend: float = 0.0) -> Stream:
        """Starts a stream of TCP poses in the base frame [m, rad] that are approached at the given speed [m/s] and
        acceleration [m/s2]; blend 0 ... 2 [m]."""
        return Stream(self._controller.servo_c(speed, acceleration, blend), self._handle_waits, pose_numbers)

    def speed_j(self, acceleration: float = 0.5) -> Stream:
        """Starts a stream of joint velocities [rad/s]; acceleration [rad/s2]."""
        return Stream(self._controller.speed_j(acceleration), self._handle_waits, floats)

    def speed_l(self, acceleration: float = 0.5) -> Stream:
        """Starts a stream of tool velocities in the base frame [m/s, rad/s]; acceleration [m/s2]."""
        return Stream(self._controller.speed_l(acceleration), self._handle_waits, floats)

    def torque(self, viscous_scale: Floats | None = None, coulomb_scale: Floats | None = None) -> Stream:
        """Starts a stream of joint torques [Nm], one per cycle, without gravity, which the controller compensates.

        viscous_scale, coulomb_scale: friction compensation per joint, 0 ... 1; None: settings of the controller. Until
        the first torques are sent, the arm holds its position. The stream ends with the cause LIMIT_REACHED if the TCP
        or the elbow exceeds the speed cap, because a torque stream cannot be slowed down. At its end, the arm is first
        decelerated by torques for 0.1 s at most. Raises VersionUnsupported before PolyScope 5.25.1 and 10.12.1; send()
        raises LimitExceeded for torques above the limits of the joints.
        """
        viscous = None if viscous_scale is None else floats(viscous_scale, "viscous_scale")
        coulomb = None if coulomb_scale is None else floats(coulomb_scale, "coulomb_scale")
        return Stream(self._controller.torque(viscous, coulomb), self._handle_waits, floats)

    def jog(self, velocity: Floats, frame: JogFrame = "base", *, custom_frame: Floats = ZEROS,
            contact_force: float = 0.0) -> Jog:
        """Jogs with a tool velocity [m/s, rad/s], or with joint velocities [rad/s] in frame "joints".

        frame: "base", "tool", "custom" (axes of custom_frame, a pose in the base frame) or "joints". contact_force:
        if above 0, the jog ends when the force at the TCP has changed by more than this value [N]. Refresh the jog
        at least every 100 ms.
        """
        one_of(frame, "frame", JOG_FRAMES)
        axes = pose_numbers(custom_frame, "custom_frame")
        native = self._controller.jog(frame, floats(velocity, "velocity"), axes, contact_force)
        return Jog(native, frame, axes, contact_force, self._handle_waits)

    def jog_while(self, callback: Callable[[Sample], Floats | None], frame: JogFrame = "base",
                  period: float = 0.02) -> None:
        """Jogs with the velocity returned by the callback, which is called every `period` [s] until it returns None.

        An exception in the callback stops the arm and is raised here. Each call takes about 50 us and needs the
        interpreter: a callback or thread that occupies it for 100 ms ends the jog.
        """
        first = callback(self.state)
        if first is None:
            return
        with self._waiting(), self.jog(first, frame) as jog:
            while (velocity := callback(self.state)) is not None and jog.refresh(velocity):
                time.sleep(period)

    def packet_loop(self, kind: LoopKind, callback: Callable[[Cycle], Floats | None], *,
                    timeout: float | None = None, at_once: bool = False) -> LoopReport:
        """Calls the callback once per packet, synchronized with the robot; its result is sent in response to the same
        packet. None ends the loop: the arm stops, which may take about 0.1 s longer than this call. Use this for
        targets with precise timing; servo_j() and similar functions are for targets at irregular times.

        kind: "servo_j" (joint positions [rad]), "servo_l" (TCP poses [m, rad]), "speed_j" [rad/s], "speed_l" [m/s,
        rad/s] or "torque" [Nm]. The callback receives a Cycle with the time, the values of the packet and their age.
        timeout: of the whole loop [s]; raises Timeout. at_once: send each target as soon as possible instead of at
        regular intervals.
        Each call takes about 30 us in addition to the callback, and waits for the interpreter: other Python threads
        hold it for up to 5 ms at a time (sys.setswitchinterval). After a call longer than a period, the next call gets
        the newest packet. No heartbeat is sent during a call: a call of 100 ms stops the arm and raises Stopped with
        the measured time. An exception in the callback or Ctrl+C stops the arm and is raised here. A blocking call
        inside the callback, including another packet_loop(), raises InvalidArgument, because nothing could end its
        wait.
        """
        one_of(kind, "kind", _LOOP_TARGETS)
        check, meaning = _LOOP_TARGETS[kind]

        def checked(values: dict[str, Any], layout: Layout) -> list[float] | None:
            values["packet"] = Sample(values["packet"], layout)
            values["q"] = values["q"].view(Joints)
            values["tcp_pose"] = values["tcp_pose"].view(Pose)
            target = callback(Cycle(**values))
            return None if target is None else check(target, f"the callback's target ({meaning})")

        with self._waiting():
            return LoopReport(**self._controller.packet_loop(kind, checked, at_once, timeout))

    # ---- queries and settings

    @property
    def tool(self) -> arm.Tool:
        """Settings of the tool and the controller: target payload, gravity, external sensor, force mode, watchdog."""
        return arm.Tool(self._controller, self._handle_waits)

    @property
    def queries(self) -> arm.Queries:
        """Queries to the robot: safety limits, joint limits, torques, contact, TCP offset."""
        return arm.Queries(self._controller, self._handle_waits)

    @property
    def pulses(self) -> arm.Pulses:
        """Pulses on digital outputs, timed by the robot."""
        return arm.Pulses(self._controller, self._handle_waits)

    def inverse_kinematics(self, pose: Floats, near: Floats | None = None, timeout: float | None = 1.0) -> Joints:
        """Joint positions [rad] for a pose of the TCP [m, rad], with the calibration of the robot. Raises NoSolution."""
        with self._waiting():
            return Joints(self._controller.inverse_kinematics(pose_numbers(pose, "pose"), None if near is None
                                                              else joint_positions(near, "near"), timeout))

    def forward_kinematics(self, q: Floats, timeout: float | None = 1.0) -> Pose:
        """Pose of the TCP [m, rad] for joint positions [rad], with the calibration of the robot."""
        with self._waiting():
            return Pose(self._controller.forward_kinematics(joint_positions(q, "q"), timeout))

    def set_payload(self, mass: float, centre_of_gravity: Floats | None = None, timeout: float | None = 1.0) -> None:
        """Sets mass [kg] and centre of gravity from the flange [m]; centre_of_gravity=None leaves it unchanged."""
        cog = None if centre_of_gravity is None else floats(centre_of_gravity, "centre_of_gravity", 3)
        with self._waiting():
            self._controller.set_payload(mass, cog, timeout)

    def set_tcp(self, tcp: Floats, timeout: float | None = 1.0) -> None:
        """Sets the TCP as a pose in the flange frame [m, rad]."""
        with self._waiting():
            self._controller.set_tcp(pose_numbers(tcp, "tcp"), timeout)

    def zero_force_sensor(self, timeout: float | None = 1.0) -> None:
        """Sets the current reading of the force sensor to zero."""
        with self._waiting():
            self._controller.zero_force_sensor(timeout)

    def force_mode(self, compliant: Sequence[bool], wrench: Floats, limits: Floats, *, frame: Floats = ZEROS,
                   kind: int = 2, timeout: float | None = 1.0) -> ForceMode:
        """Makes the arm compliant. Motions remain possible. Use the returned object in a `with` block. Without
        `with`, see ForceMode for what ends force mode.

        compliant: per axis of the frame. wrench: target on these axes [N, Nm]. limits: maximum speeds of compliant axes
        [m/s, rad/s], maximum deviation of the other axes [m, rad]. frame: a pose in the base frame. kind: 1, 2 or 3, how
        the force frame is derived from `frame` (`type` of force_mode in URScript). timeout: for the robot's confirmation,
        at the start and at the end [s].
        """
        axes = [bool(one_of(axis, "compliant", (0.0, 1.0))) for axis in floats(compliant, "compliant")]
        numbers, largest, task = floats(wrench, "wrench"), floats(limits, "limits"), pose_numbers(frame, "frame")
        one_of(kind, "kind", (1, 2, 3))
        controller, waiting = self._controller, self._handle_waits

        def begin(target: list[float], stops: int) -> None:
            with waiting():
                controller.force_mode(task, axes, target, kind, largest, stops, timeout)

        def end() -> None:
            with waiting():
                controller.end_force_mode(timeout)

        return ForceMode(self._force_blocks, controller.stops, begin, end, numbers)

    def end_force_mode(self, timeout: float | None = 1.0) -> None:
        """Ends force mode, regardless of which call started it. No effect if it is off."""
        with self._waiting():
            self._controller.end_force_mode(timeout)

    @property
    def outputs(self) -> services.Outputs:
        """Digital and analog outputs and the speed slider, on a separate connection."""
        receiver = self._receiver
        if self._outputs is None:
            native = _native.Outputs(receiver, self.address, 30004 + self._port_offset)
            self._outputs = services.Outputs(native, self._waiting)
        return self._outputs

    def registers(self, ints: Sequence[int] = (), doubles: Sequence[int] = (), bits: Sequence[int] = (),
                  timeout: float | None = 3.0) -> services.Registers:
        """Opens a connection that writes these input registers: integers and doubles 0-47, bits 64-127; the control
        program uses integers 24-34 and doubles 24-41. Raises InvalidArgument for other numbers; RegisterInUse if
        another client or a fieldbus uses one of them."""
        self._opened()
        return services.registers(self.address, 30004 + self._port_offset, ints, doubles, bits, timeout, self._waiting)

    def recover(self, consent: services.Consent, timeout: float | None = 60.0,
                progress: Callable[[str], None] | None = None) -> None:
        """Brings the robot to robot mode RUNNING and safety mode NORMAL step by step, performing only the steps that
        `consent` permits.

        progress: called with the name of each step. Raises Rejected with the reason if a step requires a consent that was
        not given, or an action at the robot.
        """
        self._opened()
        with self._waiting():
            _native.recover(self.address, self._port_offset, consent.cause_inspected, consent.restart_safety,
                            consent.power_on, consent.release_brakes, progress, timeout)
