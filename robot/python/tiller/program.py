# SPDX-License-Identifier: MIT
"""Programs of a project: build, check, simulate and run them."""
from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arguments import checked
from ._values import ZEROS, Array, Floats, Joints, Pose, floats, joint_positions, pose_numbers
from .errors import InvalidArgument, Stopped, Timeout
from .motions import Waiting
from .robot import Robot

#: A change of a digital input: time since the start [s], channel, on.
Input = tuple[float, int, bool]


@dataclass(frozen=True)
class Step:
    """A step of a program. Later changes of the program do not change this object."""

    id: str  #: unique and constant
    number: int  #: position in the program, counted from 1; changes when steps are added or removed
    kind: str  #: e.g. "moveL"; see Program.kinds()
    name: str  #: name of the kind in the window, e.g. "MoveL"
    depth: int  #: number of sections around the step
    disabled: bool  #: the program skips the step
    fields: Mapping[str, Any]  #: values in SI units; references are IDs


@dataclass(frozen=True)
class StepField:
    """A field of a step kind."""

    key: str  #: name of the argument of Program.add()
    label: str  #: name in the window
    type: str  #: "float", "int", "bool", "str", "channel" (0-7 standard, 8-15 configurable, 16-17 tool), "expression"
    optional: bool  #: the field may have no value
    minimum: float  #: smallest number, in SI units
    maximum: float  #: largest number, in SI units
    choices: tuple[str, ...]  #: the possible values; empty: any


@dataclass(frozen=True)
class StepKind:
    """A kind of step."""

    kind: str  #: name for Program.add()
    name: str  #: name in the window
    section: bool  #: contains other steps
    fields: tuple[StepField, ...]  #: the fields and their ranges


@dataclass(frozen=True)
class Problem:
    """A reason why a program cannot run."""

    step: int  #: number of the step; 0: the whole program
    step_id: str  #: ID of the step
    field: str  #: key of the field; empty: the whole step
    text: str  #: cause and suggested action


@dataclass(frozen=True)
class StepTiming:
    """The runs of a step."""

    step: int  #: number of the step
    name: str  #: name of its kind
    count: int  #: number of runs
    first: float  #: time of the first run since the start of the program [s]
    total: float  #: total duration of all runs, without pauses [s]


@dataclass(frozen=True)
class Finding:
    """A problem in a simulated run."""

    kind: str  #: "ScriptError", "RuntimeError", "ProtectiveStop", "Collision", "StepFailed", "TimeLimit"
    step: int  #: number of the step; 0: no step
    time: float  #: since the start [s]
    text: str  #: description


@dataclass(frozen=True)
class Preview:
    """A simulated run. Workpieces are not simulated."""

    completed: bool  #: the program ended normally, or is endless and completed two cycles
    endless: bool  #: the program has an endless loop
    duration: float  #: [s]
    findings: tuple[Finding, ...]  #: problems in chronological order
    steps: tuple[StepTiming, ...]  #: one per step; step number 1 is at index 0
    times: Array  #: time of each sample of the path [s]
    path_steps: NDArray[np.int64]  #: number of the running step at each sample
    q: Array  #: joint positions at each sample, one row per sample [rad]
    tcp_pose: Array  #: TCP poses at each sample in the base frame, one row per sample [m, rotation vector rad]
    end_q: Joints  #: joint positions at the end [rad]
    end_pose: Pose  #: TCP pose at the end in the base frame [m, rotation vector rad]
    outputs: int  #: digital outputs at the end, one bit per output

    @property
    def good(self) -> bool:
        """True if the program completed without a finding."""
        return self.completed and not self.findings


@dataclass(frozen=True)
class Recovery:
    """Whether a program can continue after a stop in a step.

    Each mark is "continue", "move_back" (the arm must first move to the start position of the step to continue from),
    "unsafe" (the program must not continue) or "not_reached".
    """

    step: int  #: number of the step in which the program stops
    name: str  #: name of its kind
    continue_from: int  #: number of the step to continue from; 0: the step was not reached
    protective_stop: str  #: mark for a protective stop
    operator_stop: str  #: mark for a stop by an operator
    link_loss: str  #: mark for a lost connection
    power_loss: str  #: mark for a loss of power
    reasons: tuple[str, ...]  #: reasons for the marks, in the order of the stops; empty strings for "continue"
    not_checked: str  #: why the step was not checked, e.g. because it is disabled; empty if it was checked


@checked
class ProgramRun:
    """A program on a robot; see Program.start(). `run.wait()` returns at its end.

    The program does not depend on this object. The arm stops on stop(), Robot.stop(), Robot.close() or the end of the
    robot's `with` block, on Ctrl+C or any other exception in wait() or set_variable(), on an uncaught exception, and when the process ends
    or loses the connection.
    """

    def __init__(self, native: _native.ProgramRun, names: Sequence[str], waiting: Waiting) -> None:
        self._native = native
        self._names = names
        self._waiting = waiting

    def wait(self, timeout: float | None = None) -> None:
        """Waits until the program has ended and control has been taken again. timeout [s]; None: no limit.

        Raises Timeout (the program continues), ScriptError if a step failed, Stopped (with the cause, or because the
        arm had moved since the simulation of Program.start()), UnsafeState, LinkLost, NotInControl. On
        Ctrl+C the arm stops and KeyboardInterrupt is raised.
        """
        try:
            with self._waiting():
                self._native.wait(timeout)
        except Timeout:
            raise
        except BaseException:
            self._native.stop()
            raise

    @property
    def variables(self) -> dict[str, Any]:
        """The global variables of the program, with their last values after its end. The robot sends them ten times per
        second; the dictionary is empty before the first values arrive.

        Values: bool, int, float (in single precision), str, Pose, or a list of numbers. A list with other items is a
        string in URScript; None: no value yet.
        """
        return {name: Pose(value) if is_pose and value is not None else value
                for name, value, is_pose in self._native.variables()}

    def set_variable(self, name: str, value: bool | float, timeout: float | None = 5.0) -> None:
        """Changes a variable while `state` is "waiting", and waits until the robot has confirmed the new value.

        name: a variable that a "Set variable" step sets to a number, True or False. value: in the type of the variable.
        timeout [s]. The simulation of Program.start() did not use this value: before resume(), make sure that the rest
        of the program is safe with it.
        Raises InvalidArgument with the reason if the variable cannot be changed now, and if the value may have been
        changed: Timeout without a confirmation, Stopped if the program continued or ended. On Ctrl+C or any other
        exception the program ends.
        """
        item = getattr(value, "item", lambda: value)()  # NumPy values have item()
        try:
            with self._waiting():
                self._native.set_variable(name, repr(item), timeout)
        except (InvalidArgument, Timeout, Stopped):
            raise
        except BaseException:
            self._native.stop()
            raise

    @property
    def state(self) -> str:
        """"starting", "running", "waiting" (paused before a step), "completed", "failed" (by a step) or "stopped"."""
        return str(self._native.status()["state"])

    @property
    def active(self) -> bool:
        """True until the program has ended and control has been taken again."""
        return self.state in ("starting", "running", "waiting")

    @property
    def step(self) -> int:
        """Number of the running step, or of the step before which the program waits; 0: none."""
        return int(self._native.status()["step"])

    @property
    def step_name(self) -> str:
        """Name of the kind of the current step, e.g. "MoveL"; empty without a step."""
        step = self.step
        return self._names[step - 1] if step > 0 else ""

    @property
    def last_step(self) -> int:
        """Number of the last step that was running; 0: none."""
        return int(self._native.status()["last_step"])

    @property
    def failed_step(self) -> int:
        """Number of the step that failed and ended the program; 0: none."""
        return int(self._native.status()["failed_step"])

    @property
    def seconds(self) -> float:
        """Duration so far [s]."""
        return float(self._native.status()["seconds"])

    @property
    def timings(self) -> tuple[StepTiming, ...]:
        """Number and duration of the runs of each step so far. Steps shorter than the packet interval may be missing."""
        return _timings(self._names, self._native.status()["timings"])

    @property
    def paused(self) -> bool:
        """True after pause() or step_once(), and while the program waits at a breakpoint."""
        return bool(self._native.status()["paused"])

    def pause(self) -> None:
        """Pauses the program at standstill before its next step, but not within a step or a force section."""
        self._native.pause()

    def resume(self) -> None:
        """Continues a paused program."""
        self._native.resume()

    def step_once(self) -> None:
        """Runs one step of a waiting program, which then pauses again. No effect unless `state` is "waiting"."""
        self._native.step_once()

    def finish_cycle(self, ends: bool = True) -> None:
        """Ends the program at standstill before the next cycle of its outermost endless loop; False cancels
        this request."""
        self._native.finish_cycle(ends)

    def stop(self) -> None:
        """Ends the program, without waiting; the arm brakes. wait() then raises Stopped."""
        self._native.stop()

    def __repr__(self) -> str:
        step = self.step
        return f"<tiller.ProgramRun {self.state}{f', step {step} ({self._names[step - 1]})' if step else ''}>"


def _timings(names: Sequence[str], rows: Sequence[tuple[int, float, float]]) -> tuple[StepTiming, ...]:
    return tuple(StepTiming(number, name, *row) for number, (name, row) in enumerate(zip(names, rows), 1))


@checked
class Program:
    """A program: steps that refer to the waypoints, frames, tools and patterns of a project.

        program = tiller.Program("pick")
        program.add_waypoint("above", [0, -1.57, 1.57, -1.57, -1.57, 0])
        program.add("moveJ", waypoint="above")
        with tiller.Robot("192.168.0.10") as robot:
            robot.take_control()
            program.run(robot)

    name: name of the program. model: robot model, e.g. "UR5e". Program.open() reads a program from a project file.
    """

    def __init__(self, name: str = "program", *, model: str = "UR5e") -> None:
        self._native = _native.Program(name, model)

    @classmethod
    def open(cls, path: str | os.PathLike[str], name: str | None = None) -> Program:
        """Reads a program from a project file (.tiller). name: None for the only program of the project.

        Raises InvalidArgument if no program or several programs match (lists their names), FileNotReadable, FileCorrupt.
        """
        program = cls.__new__(cls)
        program._native = _native.Program.open(os.fspath(path), name)
        return program

    def save(self, path: str | os.PathLike[str]) -> None:
        """Saves the project with the program. Overwrites only the file from which the program was read or to which it
        was saved; raises FileNotWritable if another program has changed it, or for another existing file."""
        self._native.save(os.fspath(path))

    @property
    def name(self) -> str:
        """Name of the program."""
        return self._native.name()

    # ---- build

    @staticmethod
    def kinds() -> tuple[StepKind, ...]:
        """All kinds of steps with their fields."""
        return tuple(StepKind(kind, name, section, tuple(StepField(*field[:6], tuple(field[6])) for field in fields))
                     for kind, name, section, fields in _native.step_kinds())

    @property
    def waypoints(self) -> tuple[str, ...]:
        """Names of the project's waypoints."""
        return tuple(self._native.waypoints())

    def add_waypoint(self, name: str, q: Floats, *, tcp: Floats = ZEROS, blend: float = 0.0) -> None:
        """Adds a waypoint at joint positions [rad]. tcp: pose of the TCP in the flange frame [m, rotation vector rad];
        must be the TCP of the robot when the program runs. blend: radius [m]. Raises InvalidArgument if the name exists.
        """
        self._native.add_waypoint(name, joint_positions(q, "q"), pose_numbers(tcp, "tcp"), blend)

    def add(self, kind: str, *, inside: Step | None = None, disabled: bool = False, **fields: Any) -> Step:
        """Adds a step after the last step, or as the last step of the section `inside`.

        kind and fields: see kinds(). Numbers are in SI units: m, rad, s, N, m/s, rad/s. Waypoints, frames, tools,
        payloads, patterns and programs are given by their names, e.g. waypoint="above". Raises InvalidArgument for an
        unknown kind, field or name, with the possible values; check() reports values out of range.
        """
        return self._step(self._native.add_step(kind, _json(fields), None if inside is None else inside.id, disabled))

    def change(self, step: Step, **fields: Any) -> Step:
        """Changes fields of a step and returns the changed step; None removes a value. See add()."""
        self._native.set_fields(step.id, _json(fields))
        return self._step(step.id)

    def remove(self, step: Step) -> None:
        """Removes a step and the steps inside it."""
        self._native.remove_step(step.id)

    @property
    def steps(self) -> tuple[Step, ...]:
        """All steps in the order of their numbers. The steps of a section follow it with a larger depth."""
        return tuple(Step(id, number, kind, name, depth, disabled, json.loads(fields)) for number, (
            id, kind, name, depth, disabled, fields) in enumerate(self._native.steps(), 1))

    def _step(self, identifier: str) -> Step:
        return next(step for step in self.steps if step.id == identifier)

    # ---- check and simulate

    def check(self) -> tuple[Problem, ...]:
        """The reasons why the program cannot run; empty if it can."""
        return tuple(Problem(*problem) for problem in self._native.problems())

    def script(self) -> str:
        """The program as URScript, which runs without this library. Raises InvalidArgument with the problems."""
        return self._native.script()

    def preview(self, *, start: Floats | None = None, from_step: Step | None = None, inputs: Sequence[Input] = (),
                time_limit: float = 3600.0, sample_interval: float = 0.02) -> Preview:
        """Runs the program in the simulated controller, faster than real time.

        start: joint positions [rad]; None: the first waypoint. from_step: first step, at the top level. inputs: changes
        of digital inputs: (time [s], channel, on). time_limit: maximum simulated time [s]. sample_interval: interval
        between samples of the path [s]. Raises InvalidArgument with the problems if the program cannot run. Ctrl+C
        ends the simulation.
        """
        result = self._native.preview(None if start is None else joint_positions(start, "start"), _id(from_step),
                                      _inputs(inputs), time_limit, sample_interval)
        path = result["path"]
        return Preview(
            completed=result["completed"], endless=result["endless"], duration=result["duration"],
            findings=tuple(Finding(*finding) for finding in result["findings"]),
            steps=_timings(result["names"], result["timings"]), times=path[:, 0], path_steps=path[:, 1].astype(np.int64),
            q=path[:, 2:8], tcp_pose=path[:, 8:14], end_q=Joints(result["end_q"]), end_pose=Pose(result["end_pose"]),
            outputs=result["outputs"])

    def recoverability(self, *, inputs: Sequence[Input] = (), time_limit: float = 3600.0) -> tuple[Recovery, ...]:
        """Simulates stops in each step, and checks whether the program can continue after them. May take up to a minute.

        inputs, time_limit: as in preview(). Raises ScriptError if the simulated program does not complete.
        """
        rows = []
        for step, name, continue_from, marks, not_checked in self._native.recoverability(_inputs(inputs), time_limit):
            protective_stop, operator_stop, link_loss, power_loss = (mark for mark, _ in marks)
            rows.append(Recovery(step, name, continue_from, protective_stop, operator_stop, link_loss, power_loss,
                                 tuple(reason for _, reason in marks), not_checked))
        return tuple(rows)

    # ---- run

    def start(self, robot: Robot, *, from_step: Step | None = None, breakpoints: Sequence[Step] = (),
              timeout: float | None = 5.0) -> ProgramRun:
        """Starts the program instead of the control program, at the programmed speeds. The speed cap does not apply.

        First simulates up to ten minutes of the program from the current position of the arm. from_step: first step, at
        the top level; the arm must be where the program would be. breakpoints: steps before which the program pauses.
        timeout: for the data of the robot [s].
        Raises InvalidArgument with the reasons if the program cannot run, the robot has a different model or TCP, or
        the simulation ends in a collision, a protective stop or a script error; NotInControl.
        """
        return self._started(robot, from_step, breakpoints, timeout)

    def run(self, robot: Robot, timeout: float | None = None, *, from_step: Step | None = None) -> None:
        """Runs the program and waits for its end; see start(). timeout: time limit [s]; then the program is stopped.

        Also raises the errors of ProgramRun.wait(). On Ctrl+C the arm stops.
        """
        run = self._started(robot, from_step, (), 5.0)
        try:
            run.wait(timeout)
        except Timeout:
            run.stop()
            raise

    def _started(self, robot: Robot, from_step: Step | None, breakpoints: Sequence[Step],
                 timeout: float | None) -> ProgramRun:
        controller = robot._controller
        stops = controller.stops()  # a stop while the data arrive or during the simulation prevents the start
        with robot._waiting():
            receiver = robot._receiver_of(_native.execution_fields(), timeout)
            native = self._native.start(controller, receiver, _id(from_step), [step.id for step in breakpoints], stops)
        return ProgramRun(native, self._native.names(), robot._handle_waits)

    def __repr__(self) -> str:
        return f"<tiller.Program \"{self.name}\", {len(self.steps)} steps>"


def _json(fields: Mapping[str, Any]) -> str:
    """Converts fields for the C++ library, including numpy numbers."""
    return json.dumps(fields, default=lambda value: value.item() if hasattr(value, "item") else str(value))


def _id(step: Step | None) -> str | None:
    return None if step is None else step.id


def _inputs(inputs: Sequence[Input]) -> list[Input]:
    return [(float(time), int(channel), bool(on)) for time, channel, on in inputs]
