# SPDX-License-Identifier: MIT
"""Behaviour of the arm when the process that moves it ends, for every call that moves the arm (robot/ENDS.md).

Each cell of the table is one process, in C++ or Python, that moves its own simulated arm and then ends in one way.
The simulated controller measures how long and how far the arm moves after the last packet of that process. Without
arguments, a part of the table runs that covers every call with at least one end. TILLER_ALL=1 runs all cells.
TILLER_UPDATE_TABLES=1 runs all cells and writes the table.
"""
import collections
import concurrent.futures
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

from robot import Robot

BRAKES_MS = 250
AT_ONCE = 8
ATTEMPTS = 3
TEST_TIMEOUT = 60  # [s]; only a hanging test reaches it
START = [-1.57, -1.2, -2.3, -1.2, 1.57, 0.0]
TABLE = pathlib.Path(os.environ["TILLER_SOURCE"], "robot/ENDS.md")
HELPERS = pathlib.Path(os.environ["TILLER_HELPERS"])
BEGIN, END = "<!-- table: written by tests/python/test_ends.py -->\n", "<!-- end of the table -->\n"

ENDS = ["exception", "exit", "Ctrl+C", "SIGTERM", "SIGHUP", "SIGKILL", "lost link", "object"]
SIGNALS = {"Ctrl+C": signal.SIGINT, "SIGTERM": signal.SIGTERM, "SIGHUP": signal.SIGHUP, "SIGKILL": signal.SIGKILL}
#: Signals that make a Python program end itself in its main thread.
ORDERS = {"exception": signal.SIGUSR1, "exit": signal.SIGUSR2, "object": signal.SIGALRM, "_exit": signal.SIGVTALRM,
          "leave": signal.SIGPROF}

BRAKES, GOES_ON = "brakes", "**keeps moving**"

#: call: the call as users write it. program: argument of the helper, or lines of Python. fast: TCP speed at the end [m/s].
#: turning: joint speed at the end, if not 0 [rad/s].
Row = collections.namedtuple("Row", "api call program fast hand robot unattended turning",
                             defaults=(0.05, False, (), (), 0))

SCRIPT_ENDS = tuple(end for end in ENDS if end != "object")  # ends after which an unattended script continues

NATIVE = [
    Row("C++", "Motions::moveJ", "free moveJ"),
    Row("C++", "Motions::moveJ, 1.05 rad/s", "free moveJ at 1.05", turning=1.04),
    Row("C++", "Motions::moveJ, 3 rad/s", "free moveJ at 3", turning=2.95),
    Row("C++", "Motions::moveJToPose", "free moveJToPose", 0.03),
    Row("C++", "Motions::moveL", "free moveL"),
    Row("C++", "Motions::moveL, 0.25 m/s", "free moveL at 0.25", 0.248),
    Row("C++", "Motions::moveL, 1 m/s", "free moveL at 1", 0.98),
    Row("C++", "Motions::moveLToJoints", "free moveLToJoints"),
    Row("C++", "Motions::movePath", "free path"),
    Row("C++", "Motions::moveUntilContact", "move until contact"),
    Row("C++", "Motions::startJog", "jog"),
    Row("C++", "Motions::startJog, `Holding::Free`", "free jog"),
    Row("C++", "Motions::startServoC", "servoC"),
    Row("C++", "Motions::startSpeedL, `Holding::Free`", "free speedL"),
    Row("C++", "PacketLoop::servoJ", "servoJ"),
    Row("C++", "PacketLoop::servoJ, 1.5 rad/s", "fast servoJ", turning=1.4),
    Row("C++", "PacketLoop::servoL", "servoL"),
    Row("C++", "PacketLoop::speedJ", "speedJ"),
    Row("C++", "PacketLoop::speedJ, 3 rad/s", "fast speedJ", turning=2.95),
    Row("C++", "PacketLoop::speedL", "speedL"),
    Row("C++", "PacketLoop::torque", "torque", robot=("torque",)),
    Row("C++", "Compliance::startFreedrive", "free freedrive", 0.03, True),
    Row("C++", "Compliance::startTeachMode", "teach mode", 0.03, True),
    Row("C++", "Compliance::setForceMode", "force mode", 0.02),
    Row("C++", "Programs::startFunction", "section"),
    Row("C++", "Programs::runScript", "script"),
    Row("C++", "Programs::runScript, movej at 1.05 rad/s", "fast script", turning=1.04),
    Row("C++", "Programs::runScript, `Supervision::Unattended`", "unattended script", unattended=SCRIPT_ENDS),
]

UR_RTDE = [
    Row("ur_rtde C++", "moveJ, asynchronous", "moveJ"),
    Row("ur_rtde C++", "moveJ, default speed", "moveJ, default speed", turning=1.04),
    Row("ur_rtde C++", "moveJ, 3 rad/s", "moveJ, fast", turning=2.95),
    Row("ur_rtde C++", "moveJ_IK, asynchronous", "moveJ_IK", 0.03),
    Row("ur_rtde C++", "moveL, asynchronous", "moveL"),
    Row("ur_rtde C++", "moveL, default speed", "moveL, default speed", 0.248),
    Row("ur_rtde C++", "moveL, 1 m/s", "moveL, fast", 0.98),
    Row("ur_rtde C++", "moveL_FK, asynchronous", "moveL_FK"),
    Row("ur_rtde C++", "movePath, asynchronous", "path"),
    Row("ur_rtde C++", "moveUntilContact", "move until contact"),
    Row("ur_rtde C++", "speedJ", "speedJ"),
    Row("ur_rtde C++", "speedL", "speedL"),
    Row("ur_rtde C++", "servoJ", "servoJ"),
    Row("ur_rtde C++", "servoL", "servoL", 0.04),
    Row("ur_rtde C++", "servoC", "servoC"),
    Row("ur_rtde C++", "jogStart", "jog"),
    Row("ur_rtde C++", "forceMode", "force mode", 0.02),
    Row("ur_rtde C++", "freedriveMode", "freedrive", 0.03, True),
    Row("ur_rtde C++", "teachMode", "teach mode", 0.03, True),
    Row("ur_rtde C++", "sendCustomScript", "script"),
    Row("ur_rtde C++", "sendCustomScriptFunction", "function"),
    Row("ur_rtde C++", "sendCustomScriptFile", "file"),
    Row("ur_rtde C++", "sendCustomScript, `unattended`", "unattended script", unattended=SCRIPT_ENDS),
    Row("ur_rtde C++", "sendCustomScriptFunction, `unattended`", "unattended function", unattended=SCRIPT_ENDS),
    Row("ur_rtde C++", "sendCustomScriptFile, `unattended`", "unattended file", unattended=SCRIPT_ENDS),
    Row("ur_rtde C++", "setCustomScriptFile", "custom program"),
]

C = [Row("C", "tiller_move_j", "move_j"), Row("C", "tiller_move_l", "move_l")]

PREAMBLE = """
import signal, sys, threading, time
class Ended(Exception):
    pass
class Left(Exception):
    pass
def raiser(error):
    def handler(number, frame):
        raise error
    return handler
import os
signal.signal(signal.SIGUSR1, raiser(RuntimeError("the end that the test asked for")))
signal.signal(signal.SIGUSR2, lambda number, frame: sys.exit(0))
signal.signal(signal.SIGALRM, raiser(Ended()))
signal.signal(signal.SIGPROF, raiser(Left()))
signal.signal(signal.SIGVTALRM, lambda number, frame: os._exit(0))
START = {start}
BODY = '''while True:
  movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), a=0.5, v=0.1)
  movel(pose_add(get_target_tcp_pose(), p[0,0,0.2,0,0,0]), a=0.5, v=0.1)
end
'''
SCRIPT = "def rising():\\n" + BODY + "end\\n"
def turned(angle):
    return [START[0] + angle] + START[1:]
def lowered(way):
    return POSE[:2] + [POSE[2] - way] + POSE[3:]
def shifted(way):
    return [POSE[0] + way] + POSE[1:]
def endless(move):
    back = False
    while True:
        move(back)
        back = not back
def up_and_down(tiller, low):
    program = tiller.Program("up and down")
    program.add_waypoint("high", START)
    program.add_waypoint("low", low)
    section = program.add("loop", times=0)
    for name in ("low", "high"):
        program.add("moveL", inside=section, waypoint=name)
    return program
def loop(cycle):
    begin = time.monotonic()
    while True:
        cycle(time.monotonic() - begin)
        time.sleep(0.004)
"""

UR_RTDE_PROGRAM = PREAMBLE + """
import tempfile
from rtde_control import RTDEControlInterface, Path, PathEntry
c = RTDEControlInterface(sys.argv[1])
POSE = c.getForwardKinematics()
def file():
    made = tempfile.NamedTemporaryFile("w", suffix=".script", delete=False)
    made.write(SCRIPT)
    made.close()
    return made.name
try:
{motion}
    while True:
        time.sleep(1)
except (Ended, Left) as error:
    c.disconnect(unattended=isinstance(error, Left))
    while True:
        time.sleep(1)
"""

ROBOT_PROGRAM = PREAMBLE + """
import tiller
robot = tiller.Robot(sys.argv[1], priority=0)
robot.take_control()
POSE = [float(value) for value in robot.state.tcp_pose]
def jogging(cycle):
    while True:
        cycle()
        time.sleep(0.01)
try:
{motion}
    while True:
        time.sleep(1)
except Ended:
    robot.close()
    while True:
        time.sleep(1)
"""

PYTHON_UR_RTDE = [
    Row("ur_rtde Python", "moveJ, asynchronous", "c.moveJ(turned(1.5), 0.4, 1.4, True)"),
    Row("ur_rtde Python", "moveJ, default speed", "endless(lambda back: c.moveJ(turned(0 if back else 4.5)))", turning=1.04),
    Row("ur_rtde Python", "moveJ, 3 rad/s", "endless(lambda back: c.moveJ(turned(0 if back else 4.5), 3.0, 5.0))",
        turning=2.95),
    Row("ur_rtde Python", "moveJ_IK, asynchronous", "c.moveJ_IK(lowered(0.3), 0.4, 1.4, True)", 0.03),
    Row("ur_rtde Python", "moveL, asynchronous", "c.moveL(lowered(0.3), 0.1, 0.5, True)"),
    Row("ur_rtde Python", "moveL, default speed", "endless(lambda back: c.moveL(shifted(0 if back else 0.5)))", 0.248),
    Row("ur_rtde Python", "moveL, 1 m/s", "endless(lambda back: c.moveL(shifted(0 if back else 0.5), 1.0, 5.0))", 0.98),
    Row("ur_rtde Python", "moveL_FK, asynchronous", "c.moveL_FK(turned(0.5), 0.1, 0.5, True)"),
    Row("ur_rtde Python", "moveJ along a path, asynchronous",
        "c.moveJ([turned(1.0) + [0.4, 1.4, 0.0], turned(-1.0) + [0.4, 1.4, 0.0]], True)"),
    Row("ur_rtde Python", "moveUntilContact", "c.moveUntilContact([0, 0, -0.1, 0, 0, 0])"),
    Row("ur_rtde Python", "speedJ", "loop(lambda t: c.speedJ([0.4, 0, 0, 0, 0, 0], 1.4))"),
    Row("ur_rtde Python", "speedL", "loop(lambda t: c.speedL([0, 0, -0.1, 0, 0, 0], 0.5))"),
    Row("ur_rtde Python", "servoJ", "loop(lambda t: c.servoJ(turned(0.3 * t), 0, 0, 0.004, 0.1, 300))"),
    Row("ur_rtde Python", "servoL", "loop(lambda t: c.servoL(lowered(0.08 * t), 0, 0, 0.004, 0.1, 300))", 0.04),
    Row("ur_rtde Python", "servoC", "loop(lambda t: c.servoC(lowered(0.3), 0.1, 0.5))"),
    Row("ur_rtde Python", "jogStart", "c.jogStart([0, 0, -0.1, 0, 0, 0])"),
    Row("ur_rtde Python", "forceMode",
        "c.forceMode([0] * 6, [0, 0, 1, 0, 0, 0], [0, 0, -10, 0, 0, 0], 2, [2, 2, 0.1, 1, 1, 1])", 0.02),
    Row("ur_rtde Python", "freedriveMode", "c.freedriveMode()", 0.03, True),
    Row("ur_rtde Python", "teachMode", "c.teachMode()", 0.03, True),
    Row("ur_rtde Python", "sendCustomScript", "c.sendCustomScript(SCRIPT)"),
    Row("ur_rtde Python", "sendCustomScriptFunction", "c.sendCustomScriptFunction('rising', BODY)"),
    Row("ur_rtde Python", "sendCustomScriptFile", "c.sendCustomScriptFile(file())"),
    Row("ur_rtde Python", "sendCustomScript, `unattended`", "c.sendCustomScript(SCRIPT, unattended=True)",
        unattended=("SIGTERM", "SIGHUP", "SIGKILL", "lost link")),
    Row("ur_rtde Python", "sendCustomScriptFunction, `unattended`",
        "c.sendCustomScriptFunction('rising', BODY, unattended=True)",
        unattended=("SIGTERM", "SIGHUP", "SIGKILL", "lost link")),
    Row("ur_rtde Python", "sendCustomScriptFile, `unattended`", "c.sendCustomScriptFile(file(), unattended=True)",
        unattended=("SIGTERM", "SIGHUP", "SIGKILL", "lost link")),
    Row("ur_rtde Python", "setCustomScriptFile", "c.setCustomScriptFile(file())"),
]

PYTHON_NATIVE = [
    Row("Python", "move_j", "move = robot.move_j(turned(1.5), 0.4)"),
    Row("Python", "move_j, 1.05 rad/s",
        "robot.speed_cap = 3.0\nendless(lambda back: robot.move_j(turned(0 if back else 4.5), 1.05, 5.0).wait())",
        turning=1.04),
    Row("Python", "move_j, 3 rad/s",
        "robot.speed_cap = 3.0\nendless(lambda back: robot.move_j(turned(0 if back else 4.5), 3.0, 5.0).wait())",
        turning=2.95),
    Row("Python", "move_j_to_pose", "move = robot.move_j_to_pose(lowered(0.3), 0.4)", 0.03),
    Row("Python", "move_l", "move = robot.move_l(lowered(0.3), 0.1, 0.5)"),
    Row("Python", "move_l, 0.25 m/s",
        "robot.speed_cap = 3.0\nendless(lambda back: robot.move_l(shifted(0 if back else 0.5), 0.25, 5.0).wait())",
        0.248),
    Row("Python", "move_l, 1 m/s",
        "robot.speed_cap = 3.0\nendless(lambda back: robot.move_l(shifted(0 if back else 0.5), 1.0, 5.0).wait())", 0.98),
    Row("Python", "move_l_to_joints", "move = robot.move_l_to_joints(turned(0.5), 0.1, 0.5)"),
    Row("Python", "move_path",
        "move = robot.move_path([tiller.PathMove(lowered(way), kind='l', pose=True, speed=0.1, acceleration=0.5) "
        "for way in (0.2, 0.0)])"),
    Row("Python", "move_until_contact", "robot.move_until_contact([0, 0, -0.1, 0, 0, 0]).wait()"),
    Row("Python", "servo_j", "s = robot.servo_j()\nloop(lambda t: s.send(turned(0.3 * t)))"),
    Row("Python", "servo_l", "s = robot.servo_l()\nloop(lambda t: s.send(lowered(0.08 * t)))", 0.04),
    Row("Python", "servo_c", "s = robot.servo_c(0.1, 0.5)\nloop(lambda t: s.send(lowered(0.3)))"),
    Row("Python", "speed_j", "s = robot.speed_j()\nloop(lambda t: s.send([0.4, 0, 0, 0, 0, 0]))"),
    Row("Python", "speed_l", "s = robot.speed_l()\nloop(lambda t: s.send([0, 0, -0.1, 0, 0, 0]))"),
    Row("Python", "torque", "s = robot.torque()\n"
        "loop(lambda t: s.send([60 * (0.46 - float(robot.state.qd[0])), 0, 0, 0, 0, 0]))", robot=("torque",)),
    Row("Python", "jog", "j = robot.jog([0, 0, -0.1, 0, 0, 0])\njogging(j.refresh)"),
    Row("Python", "jog_while", "robot.jog_while(lambda state: [0, 0, -0.1, 0, 0, 0])"),
    Row("Python", "packet_loop", "robot.packet_loop('speed_j', lambda now: [0.4, 0, 0, 0, 0, 0])"),
    Row("Python", "freedrive", "move = robot.freedrive()", 0.03, True),
    Row("Python", "force_mode", "mode = robot.force_mode([False, False, True, False, False, False], [0, 0, -10, 0, 0, 0], "
        "[2, 2, 0.1, 1, 1, 1])\nmode.__enter__()", 0.02),
    Row("Python", "run_function", "move = robot.run_function(BODY)"),
    Row("Python", "run_script", "robot.run_script(SCRIPT)"),
    Row("Python", "Program.run", "up_and_down(tiller, robot.inverse_kinematics(lowered(0.2))).run(robot)"),
    Row("Python", "Program.start", "run = up_and_down(tiller, robot.inverse_kinematics(lowered(0.2))).start(robot)"),
    Row("Python", "run_script, `unattended`", "robot.run_script(SCRIPT, unattended=True)",
        unattended=("SIGTERM", "SIGHUP", "SIGKILL", "lost link")),
]

ROWS = NATIVE + C + PYTHON_NATIVE + UR_RTDE + PYTHON_UR_RTDE

#: Additional ends, each tested with a move and with a script. "leave" requests that a move continues.
FURTHER = [
    ("C++", "`leave(Supervision::Unattended)`", "leave", ("free moveJ", "script")),
    ("C++", "`std::abort`", "abort", ("free moveJ", "script")),
    ("C++", "`_exit`", "_exit", ("free moveJ", "script")),
    ("C++", "write to a closed pipe (SIGPIPE)", "closed pipe", ("free moveJ", "script")),
    ("C++", "killed while a forked child runs", "fork", ("free moveJ", "script")),
    ("ur_rtde C++", "`disconnect(true)`", "leave", ("moveJ", "script")),
    ("ur_rtde C++", "`std::abort`", "abort", ("moveJ", "script")),
    ("ur_rtde C++", "`_exit`", "_exit", ("moveJ", "script")),
    ("ur_rtde C++", "write to a closed pipe (SIGPIPE)", "closed pipe", ("moveJ", "script")),
    ("ur_rtde C++", "killed while a forked child runs", "fork", ("moveJ", "script")),
    ("Python", "`os._exit`", "_exit", ("move = robot.move_j(turned(1.5), 0.4)", "robot.run_script(SCRIPT)")),
    ("Python", "main thread ends, a daemon thread moves the arm", "exit",
     tuple(f"def work():\n    {call}\nthreading.Thread(target=work, daemon=True).start()" for call in
           ("robot.move_j(turned(1.5), 0.4).wait()", "robot.run_script(SCRIPT)"))),
    ("ur_rtde Python", "`disconnect(unattended=True)`", "leave",
     ("c.moveJ(turned(1.5), 0.4, 1.4, True)", "c.sendCustomScript(SCRIPT)")),
    ("ur_rtde Python", "`os._exit`", "_exit", ("c.moveJ(turned(1.5), 0.4, 1.4, True)", "c.sendCustomScript(SCRIPT)")),
    ("ur_rtde Python", "main thread ends, a daemon thread moves the arm", "exit",
     tuple(f"threading.Thread(target=lambda: {call}, daemon=True).start()" for call in
           ("c.moveJ(turned(1.5), 0.4)", "c.sendCustomScript(SCRIPT)"))),
]

#: milliseconds, radians: motion after the last packet. late: time for which the arm still moved after the command [ms].
Seen = collections.namedtuple("Seen", "what milliseconds radians late", defaults=(0,))


class Mover:
    """The process that moves the arm."""

    def __init__(self, row, host):
        self._python = "Python" in row.api
        if row.api == "C++":
            command = [HELPERS / "tiller_moving_helper", host, "30001", "30004", row.program]
        elif row.api == "C":
            command = [HELPERS / "tiller_c_mover", host, row.program]
        elif row.api == "ur_rtde C++":
            command = [HELPERS / "ur_rtde_mover", host, row.program]
        else:
            template = UR_RTDE_PROGRAM if row.api.startswith("ur_rtde") else ROBOT_PROGRAM
            motion = "\n".join("    " + line for line in row.program.split("\n"))
            command = [sys.executable, "-c", template.format(start=START, motion=motion), host]
        self._is_ur_rtde = row.api == "ur_rtde C++"
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True)
        if self._is_ur_rtde:
            self.process.stdout.readline()
            self.tell("begin")

    def tell(self, word):
        self.process.stdin.write(word + "\n")
        self.process.stdin.flush()

    def end(self, how, robot):
        if how == "lost link":
            robot.tell("cut")
        elif how in SIGNALS:
            self.process.send_signal(SIGNALS[how])
        elif self._python:
            self.process.send_signal(ORDERS[how])
        elif how == "object" and self._is_ur_rtde:
            self.tell("disconnect")
        else:
            self.tell(how)
            if how == "fork":
                while "forked" not in self.process.stdout.readline():
                    pass
                self.process.kill()

    def close(self):
        self.process.kill()
        # A forked child may keep the pipes open for longer.
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            pipe.close()
        self.process.wait()


def attempt(row, end):
    robot = Robot("real", "low", *row.robot)
    mover = Mover(row, robot.host)
    try:
        deadline = time.monotonic() + TEST_TIMEOUT
        moving_since = None
        word, fast = ("turning", row.turning) if row.turning else ("speed", row.fast)
        while float(robot.tell(word)) < fast:
            if time.monotonic() > deadline or mover.process.poll() is not None:
                return None
            if row.hand:
                # Apply the force only now, because a force at the start of freedrive causes a protective stop.
                moving_since = moving_since or time.monotonic()
                if time.monotonic() > moving_since + 1.5:
                    robot.tell("push")
            time.sleep(0.005)
        mover.end(end, robot)
        milliseconds, radians, late, state = robot.tell("watch").split()
        what = GOES_ON if state == "moves" or float(milliseconds) > BRAKES_MS else BRAKES
        return Seen(what, float(milliseconds), float(radians), float(late))
    finally:
        mover.close()
        robot.close()


def run(row, end):
    """Returns the behaviour of the arm. On a busy computer, the process may be late, and its motion may end before the
    process."""
    for _ in range(ATTEMPTS):
        seen = attempt(row, end)
        if seen is not None and (seen.what == expected(row, end) or seen.what == GOES_ON):
            return seen
    return seen


def expected(row, end):
    return GOES_ON if end in row.unattended else BRAKES


def cells():
    """The cells to run. A partial run contains each call once, with the ends distributed evenly."""
    everything = [(row, end) for row in ROWS for end in ENDS]
    if {"TILLER_ALL", "TILLER_UPDATE_TABLES"} & os.environ.keys():
        return everything
    return [(row, ENDS[i % len(ENDS)]) for i, row in enumerate(ROWS)]


def further_rows(entry):
    api, name, _, (move, script) = entry
    return Row(api, name, move, unattended=("leave",)), Row(api, name, script)


def further_cells():
    return [(row, entry[2]) for entry in FURTHER for row in further_rows(entry)]


def name_of(row):
    call, comma, rest = row.call.partition(",")
    return f"`{call}`{comma}{rest}"


def table(seen, further):
    """The generated text between the markers."""
    lines = []
    titles = {"C++": "C++", "C": "C (`tiller_c.h`)", "Python": "Python (`tiller.Robot`)", "ur_rtde C++": "`ur_rtde`, C++",
              "ur_rtde Python": "`ur_rtde`, Python"}
    for api, title in titles.items():
        lines += [f"### {title}", "", "| call | " + " | ".join(ENDS) + " | longest |", "|---" * (len(ENDS) + 2) + "|"]
        for row in (row for row in ROWS if row.api == api):
            here = [seen[row, end] for end in ENDS]
            braked = [cell for cell in here if cell.what == BRAKES]
            longest = max(braked, key=lambda cell: cell.milliseconds)
            lines.append(f"| {name_of(row)} | " + " | ".join(cell.what for cell in here)
                         + f" | {longest.milliseconds:.0f} ms, {max(cell.radians for cell in braked):.2f} rad |")
        lines.append("")
    lines += ["### Other ways to end", "", "| API | end | move | script |", "|---|---|---|---|"]
    for entry in FURTHER:
        api, name, end, _ = entry
        lines.append(f"| {titles[api]} | {name} | " + " | ".join(further[row, end].what for row in further_rows(entry)) + " |")
    return "\n".join(lines) + "\n"


def without_figures(text):
    return [re.sub(r"\| [^|]* rad \|$", "", line) for line in text.split("\n") if line.startswith("| ")]


class TestEnds(unittest.TestCase):
    def check(self, todo):
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            seen = dict(zip(todo, pool.map(lambda cell: run(*cell), todo)))
        for (row, end), cell in seen.items():
            with self.subTest(f"{row.api}: {row.call}, {end}"):
                self.assertIsNotNone(cell, "the arm never moved")
                print(f"{row.api}: {row.call}, {end}: {cell.what}, {cell.milliseconds:.0f} ms, {cell.radians:.3f} rad, "
                      f"{cell.late:.0f} ms after the order",
                      file=sys.stderr)
                self.assertEqual(cell.what, expected(row, end))
        return seen

    def test_every_end_brakes_the_arm(self):
        further = self.check(further_cells())
        seen = self.check(cells())
        if "TILLER_UPDATE_TABLES" in os.environ:
            text = TABLE.read_text(encoding="utf-8")
            before, rest = text.split(BEGIN)
            after = rest.split(END)[1]
            TABLE.write_text(before + BEGIN + table(seen, further) + END + after, encoding="utf-8")

    def test_the_table_is_up_to_date(self):
        """Each cell of the table must equal the expectation of its row. The other test compares the expectation with the
        behaviour of the arm."""
        rows = {(row, end): Seen(expected(row, end), 0, 0) for row in ROWS for end in ENDS}
        further = {(row, end): Seen(expected(row, end), 0, 0) for row, end in further_cells()}
        text = TABLE.read_text(encoding="utf-8").split(BEGIN)[1].split(END)[0]
        self.assertEqual(without_figures(text), without_figures(table(rows, further)))


if __name__ == "__main__":
    unittest.main()
