# SPDX-License-Identifier: MIT
"""Monitors, moves and simulates Universal Robots arms.

    import tiller

    with tiller.Robot("192.168.0.10") as robot:
        print(robot.state.q)                                    # rad, a numpy array
        robot.take_control()
        robot.move_j(robot.state.q + [0.1, 0, 0, 0, 0, 0]).wait()

SI units throughout: m, rad, s, N, Nm, A, kg; poses are position and rotation vector in the base frame. Samples return
joint positions and poses as Joints and Pose, arrays that are checked when passed as arguments. Without a robot: `with
tiller.Simulator() as simulator: robot = tiller.Robot(simulator.address)`.
"""
from . import collision, doctor, errors, kinematics
from ._native import __version__
from ._values import Joints, Pose
from .arm import JointLimits, Pulses, Queries, Tool
from .collision import CollisionCheck
from .doctor import examine
from .errors import Error
from .kinematics import Kinematics
from .modes import ControlLoss, LimiterKind, RobotMode, RuntimeState, SafetyMode, StopCause
from .motions import ForceMode, Jog, Move, PathMove, Plan, Progress, Stream
from .program import Finding, Preview, Problem, Program, ProgramRun, Recovery, Step, StepField, StepKind, StepTiming
from .receive import Condition, Recording, Sample, Samples, read_recording
from .robot import ControlStatus, Cycle, LinkCounters, LoopReport, Robot
from .services import Consent, Dashboard, Outputs, Registers, Service
from .simulator import SimulatedState, Simulator

__all__ = ["CollisionCheck", "Condition", "Consent", "ControlLoss", "ControlStatus", "Cycle", "Dashboard", "Error",
           "Finding", "ForceMode", "Jog", "JointLimits", "Joints", "Kinematics", "LimiterKind", "LinkCounters",
           "LoopReport", "Move", "Outputs", "PathMove", "Plan", "Pose", "Preview", "Problem", "Program", "ProgramRun",
           "Progress", "Pulses", "Queries", "Recording", "Recovery", "Registers", "Robot", "RobotMode", "RuntimeState",
           "SafetyMode", "Sample", "Samples", "Service", "SimulatedState", "Simulator", "Step", "StepField",
           "StepKind", "StepTiming", "StopCause", "Stream", "Tool", "__version__", "collision", "doctor", "errors",
           "examine", "kinematics", "read_recording"]
