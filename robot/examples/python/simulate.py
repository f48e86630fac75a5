# SPDX-License-Identifier: MIT
"""Runs without a robot: a simulated robot in this process, in virtual time, with a fault."""
import tiller

with tiller.Simulator("UR10e", virtual=True) as simulator, simulator.robot() as robot:
    robot.take_control()
    move = robot.move_j(robot.state.q + [1.0, 0, 0, 0, 0, 0])
    simulator.step(0.5)  # half a second of virtual time
    simulator.fault("protective-stop")
    try:
        move.wait()
    except tiller.Error as error:
        print(error)
    simulator.step(0.2)
    print(robot.state.safety_mode, simulator.truth.qd.round(3))
