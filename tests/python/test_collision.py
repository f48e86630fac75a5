# SPDX-License-Identifier: MIT
"""The collision check: contacts, examined moves, and jogs that end before an obstacle."""
import unittest

import numpy as np
import tiller
from tiller import errors
from tiller.collision import Box, CollisionCheck, Plane

LIMIT = 60.0  # [s]; only a hanging test reaches it
READY = np.array([-1.57, -1.75, -1.92, -1.05, 1.57, 0.0])


def height():
    return tiller.Kinematics("UR5e").forward(READY)[2]


class TestCollision(unittest.TestCase):
    def test_contacts_with_the_arm_and_the_surroundings(self):
        self.assertIsNone(CollisionCheck("UR5e").at(READY))
        folded = CollisionCheck("UR5e").at([0, 0, -3.1, 0, 0, 0])
        self.assertTrue(folded.with_arm)
        self.assertLess(folded.distance, 0.001)
        self.assertEqual(list(folded.q), [0, 0, -3.1, 0, 0, 0])
        place = tiller.Kinematics("UR5e").forward(READY)
        inside = CollisionCheck("UR5e", boxes=[Box([*place[:3], 0, 0, 0], [0.1, 0.1, 0.1], name="pillar")]).at(READY)
        self.assertEqual((inside.other, inside.with_arm), ("pillar", False))
        above = CollisionCheck("UR5e", planes=[Plane([0, 0, height() + 0.1, 0, 0, 0], name="floor")]).at(READY)
        self.assertEqual(above.other, "floor")

    def test_a_path_keeps_the_safety_distance(self):
        plane = Plane([0, 0, height() - 0.2, 0, 0, 0], name="table")
        path = [READY, READY + [0.3, 0, 0, 0, 0, 0], READY + [0.3, -0.9, 0, 0, 0, 0]]  # turns, then goes down
        free, near = (CollisionCheck("UR5e", planes=[plane], safety_distance=distance) for distance in (0.0, 0.1))
        lower = free.along(path)
        self.assertTrue(1 < lower.at < 2, lower)
        higher = near.along(path)
        self.assertLess(higher.at, lower.at)
        self.assertAlmostEqual(higher.distance, 0.1, 2)
        self.assertIsNone(free.along(path[:2]))

    def test_a_move_is_examined_before_it_starts(self):
        check = CollisionCheck("UR5e", planes=[Plane([0, 0, height() - 0.2, 0, 0, 0], name="table")])
        free = check.examine(READY, READY + [0.5, 0, 0, 0, 0, 0], speed=0.5)
        self.assertEqual((free.limit, free.blocked, free.fraction, free.contact), (None, False, 1.0, None))
        self.assertTrue(1.0 < free.duration < 2.0, free.duration)
        blocked = check.examine(READY, READY + [0, -0.9, 0, 0, 0, 0])
        self.assertEqual((blocked.limit, blocked.blocked, blocked.contact.other), ("collision", True, "table"))
        self.assertTrue(0 < blocked.fraction < 1)
        turned = check.examine(READY, READY + [0, 0, 0, 0, 0, 7], speed=0.5)
        self.assertEqual((turned.limit, turned.joint), ("joint_range", 5))
        line = check.examine(READY, READY + [3.1, 0, 0, 0, 0, 0], linear=True)
        self.assertTrue(line.blocked)

    def test_invalid_arguments_are_refused(self):
        check = CollisionCheck("UR5e")
        for call in (lambda: check.at([0.0] * 5), lambda: check.at([np.nan] * 6), lambda: CollisionCheck("UR99"),
                     lambda: CollisionCheck("UR5e", boxes=[Box([0.0] * 6, [1, 1, 0])]),
                     lambda: CollisionCheck("UR5e", tool_radius=-1), lambda: CollisionCheck("UR5e", tool_radius="x"),
                     lambda: CollisionCheck("UR5e", safety_distance=np.nan),
                     lambda: check.examine(READY, READY, speed=0), lambda: check.at(tiller.Pose([0.0] * 6))):
            with self.assertRaises(errors.InvalidArgument):
                call()

    def test_a_jog_ends_at_the_safety_distance(self):
        with tiller.Simulator(virtual=True, start=READY) as simulator, simulator.robot(timeout=LIMIT) as robot:
            robot.take_control(LIMIT)
            table = Plane([0, 0, robot.state.tcp_pose[2] - 0.2, 0, 0, 0], name="table")
            robot.set_collision_check(CollisionCheck("UR5e", planes=[table], safety_distance=0.05))
            with robot.jog([0, 0, -0.2, 0, 0, 0]) as jog:
                for _ in range(500):
                    if not jog.refresh():
                        break
                    simulator.step(0.02)
                self.assertIs(jog.cause, tiller.StopCause.LIMIT_REACHED)
            # The lowest body is the tool flange, whose capsule is larger than its centre line.
            self.assertGreater(robot.state.tcp_pose[2], table.pose[2] + 0.05)
            robot.set_collision_check(None)
            with robot.jog([0, 0, -0.1, 0, 0, 0]) as jog:
                for _ in range(20):
                    self.assertTrue(jog.refresh())
                    simulator.step(0.02)


if __name__ == "__main__":
    unittest.main()
