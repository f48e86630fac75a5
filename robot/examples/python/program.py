# SPDX-License-Identifier: MIT
"""Builds a program of two moves, simulates it, and runs it with a breakpoint."""
import sys
import time

import tiller

with tiller.Robot(sys.argv[1]) as robot:
    program = tiller.Program("there and back")
    program.add_waypoint("here", robot.state.q)
    program.add_waypoint("there", robot.state.q + [0.3, 0, 0, 0, 0, 0])  # rad
    program.add("moveJ", waypoint="there")
    back = program.add("moveJ", waypoint="here")
    preview = program.preview(start=robot.state.q)
    print(f"simulated: {preview.duration:.1f} s, {len(preview.findings)} problems")
    robot.take_control()
    run = program.start(robot, breakpoints=[back])
    while run.active:
        if run.state == "waiting":
            print("paused before step", run.step, run.step_name)
            run.resume()
        time.sleep(0.05)
    run.wait()  # raises the error of the program, if any
    print(run.state, [f"{step.name} {step.total:.1f} s" for step in run.timings])
