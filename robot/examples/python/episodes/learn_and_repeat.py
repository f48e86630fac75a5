# SPDX-License-Identifier: MIT
"""Learns a movement from demonstrations, and repeats it from the current position of the arm.

    tiller-cli record ROBOT --out demo.mcap               # while guiding the arm through the movement
    tiller-cli episodes demo.mcap --out demos.h5 --rate 50
    learn_and_repeat.py ROBOT demos.h5 --rate 50

The movement becomes a dynamic movement primitive, as in listing 4 of the ur_rtde paper: a spring that pulls each joint to
the end of the demonstration, and a learned force that makes it follow the demonstrated path. Listing 4 reads one CSV file;
this program reads all episodes of the file. Source: Ijspeert et al., Dynamical movement primitives (2013).
"""
import argparse

import h5py
import numpy as np

PERIOD = 0.002  # time between two packets of the robot [s]


class MovementPrimitive:
    """All joints of one movement. Time is relative to its duration: 1 is the end."""

    DECAY = 4.0  # decay rate of the phase, which decreases from 1 towards 0
    STIFFNESS = 600.0
    DAMPING = 2 * STIFFNESS ** 0.5  # critically damped: reaches the goal without overshoot

    def __init__(self, bases=40):
        self.centres = np.exp(-self.DECAY * np.linspace(0, 1, bases))
        gaps = np.diff(self.centres)
        self.widths = 1 / np.append(gaps, gaps[-1]) ** 2

    def _bases(self, phase):
        weights = np.exp(-self.widths * (np.atleast_1d(phase)[:, None] - self.centres) ** 2)
        return weights / weights.sum(axis=1, keepdims=True) * np.atleast_1d(phase)[:, None]

    def learn(self, demonstrations, period):
        """demonstrations: joint positions [rad], one row per period [s]."""
        features, forces = [], []
        for q in demonstrations:
            duration = (len(q) - 1) * period
            t = np.linspace(0, 1, len(q))
            velocity = np.gradient(q, t, axis=0)
            acceleration = np.gradient(velocity, t, axis=0)
            features.append(self._bases(np.exp(-self.DECAY * t)))
            forces.append(acceleration - self.STIFFNESS * (q[-1] - q) + self.DAMPING * velocity)
        self.weights = np.linalg.lstsq(np.vstack(features), np.vstack(forces), rcond=1e-6)[0]
        self.goal = np.mean([q[-1] for q in demonstrations], axis=0)
        self.duration = float(np.mean([(len(q) - 1) * period for q in demonstrations]))

    def way_from(self, start, period, settle=0.5):
        """Joint positions, one row per period, extended by `settle` seconds to come to rest."""
        steps = int(round((self.duration + settle) / period))
        step = period / self.duration
        q, velocity, rows = np.array(start, float), np.zeros(len(start)), []
        for force in self._bases(np.exp(-self.DECAY * step * np.arange(steps))) @ self.weights:
            velocity += step * (self.STIFFNESS * (self.goal - q) - self.DAMPING * velocity + force)
            q = q + step * velocity
            rows.append(q)
        return np.array(rows)


def demonstrations_in(path):
    with h5py.File(path) as file:  # pyright: ignore[reportAttributeAccessIssue]
        return [demo["obs/actual_q"][:] for _, demo in sorted(file["data"].items())]


def repeat(address, movement):
    import tiller  # only needed to move an arm

    with tiller.Robot(address) as robot:
        robot.take_control()
        rows = iter(movement.way_from(robot.state.q, PERIOD))
        report = robot.packet_loop("servo_j", lambda cycle: next(rows, None))  # one target per packet
        print(report.cycles, "cycles,", report.missed, "missed")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=str(__doc__).splitlines()[0])
    parser.add_argument("robot", help="address of the robot; - only learns")
    parser.add_argument("episodes", help="what tiller-cli episodes wrote")
    parser.add_argument("--rate", type=float, default=20, help="rows a second in it (20)")
    given = parser.parse_args()
    demonstrated = demonstrations_in(given.episodes)
    movement = MovementPrimitive()
    movement.learn(demonstrated, 1 / given.rate)
    learned = movement.way_from(demonstrated[0][0], 1 / given.rate, settle=0)
    apart = np.abs(learned - demonstrated[0][1:len(learned) + 1]).max()
    print(f"learned from {len(demonstrated)} demonstrations of {movement.duration:.2f} s, {apart:.4f} rad apart at most")
    if given.robot != "-":
        repeat(given.robot, movement)
