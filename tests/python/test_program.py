# SPDX-License-Identifier: MIT
"""Programs: tiller.Program with the simulated controller, in virtual time."""
import os
import tempfile
import unittest

import numpy as np
import tiller
from tiller import errors

TIMEOUT = 60.0  # [s]; only a hanging test reaches it
START = [-1.6, -1.7, -2.2, -0.8, 1.6, 0.0]
TURNED = [-1.2, -1.7, -2.2, -0.8, 1.6, 0.0]


def moves(times=2):
    """A loop with two moves and a pause."""
    program = tiller.Program("moves")
    program.add_waypoint("start", START)
    program.add_waypoint("turned", TURNED)
    loop = program.add("loop", times=times)
    program.add("moveJ", inside=loop, waypoint="turned")
    program.add("wait", inside=loop, time=0.2)
    program.add("moveJ", inside=loop, waypoint="start")
    return program


class TestBuild(unittest.TestCase):
    def test_steps_are_numbered_in_the_order_of_the_tree(self):
        program = moves()
        self.assertEqual([(step.number, step.kind, step.depth) for step in program.steps],
                         [(1, "loop", 0), (2, "moveJ", 1), (3, "wait", 1), (4, "moveJ", 1)])
        self.assertEqual(program.steps[1].name, "MoveJ")
        self.assertEqual(program.waypoints, ("start", "turned"))
        self.assertEqual(program.check(), ())
        changed = program.change(program.steps[2], time=np.float64(0.5))
        self.assertEqual(changed.fields["time"], 0.5)
        program.remove(program.steps[0])
        self.assertEqual(program.steps, ())

    def test_wrong_names_are_refused_with_the_possible_ones(self):
        program = moves()
        for call, text in ((lambda: program.add("jump"), '"moveJ"'),
                           (lambda: program.add("wait", seconds=1), '"time"'),
                           (lambda: program.add("moveJ", waypoint="nowhere"), '"turned"'),
                           (lambda: program.add("setOutput", output="DO 99"), '"DO 0"'),
                           (lambda: program.add("wait", inside=program.steps[1]), "cannot contain steps"),
                           (lambda: program.add_waypoint("start", START), "already has a waypoint"),
                           (lambda: tiller.Program("a", model="UR99"), "UR5e")):
            with self.subTest(text), self.assertRaises(errors.InvalidArgument) as raised:
                call()
            self.assertIn(text, str(raised.exception))
        self.assertEqual(len(program.steps), 4)

    def test_problems_name_the_step_and_the_field(self):
        program = moves()
        program.change(program.steps[2], time=-1)
        problem, = program.check()
        self.assertEqual((problem.step, problem.step_id, problem.field), (3, program.steps[2].id, "time"))
        for call in (program.script, program.preview, program.recoverability):
            with self.assertRaisesRegex(errors.InvalidArgument, r"step 3 \(Wait\)"):
                call()

    def test_names_and_channels_become_values(self):
        program = moves()
        step = program.add("setOutput", output="DO 3", value=True)
        self.assertEqual(step.fields["output"], 3)
        self.assertIn("set_standard_digital_out(3, True)", program.script())
        kinds = {kind.kind: kind for kind in tiller.Program.kinds()}
        self.assertTrue(kinds["loop"].section)
        self.assertEqual({field.key: field.type for field in kinds["wait"].fields}, {"time": "float"})

    def test_a_saved_program_is_the_same_when_it_is_read(self):
        program = moves()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cell.tiller")
            program.save(path)
            read = tiller.Program.open(path)
            self.assertEqual((read.name, read.steps, read.script()), (program.name, program.steps, program.script()))
            read.add("wait", time=1)
            read.save(path)
            with self.assertRaisesRegex(errors.FileNotWritable, "another program has changed it"):
                program.save(path)
            self.assertEqual(len(tiller.Program.open(path, "moves").steps), 5)
            with self.assertRaisesRegex(errors.InvalidArgument, "moves"):
                tiller.Program.open(path, "other")
            with self.assertRaises(errors.FileNotReadable):
                tiller.Program.open(os.path.join(folder, "missing.tiller"))


class TestSimulated(unittest.TestCase):
    def test_a_preview_has_durations_and_the_path(self):
        preview = moves().preview()
        self.assertTrue(preview.good)
        self.assertEqual([step.count for step in preview.steps], [1, 2, 2, 2])
        self.assertAlmostEqual(preview.steps[2].total, 0.4, delta=0.02)
        self.assertAlmostEqual(sum(step.total for step in preview.steps), preview.duration, delta=0.1)
        np.testing.assert_allclose(preview.end_q, START, atol=1e-3)
        self.assertEqual(preview.q.shape, (len(preview.times), 6))
        np.testing.assert_allclose(preview.q[:, 0].max(), TURNED[0], atol=1e-3)
        np.testing.assert_allclose(preview.tcp_pose[-1], preview.end_pose, atol=1e-3)

    def test_findings_name_their_steps(self):
        program = moves()
        program.add("fail", text="No part")
        finding, = program.preview().findings
        self.assertEqual((finding.kind, finding.step), ("StepFailed", 5))

    def test_inputs_change_at_their_times(self):
        program = moves()
        program.add("waitInput", input="DI 1", value=True)
        self.assertGreater(program.preview(inputs=[(9.0, 1, True)]).duration, 9.0)
        self.assertEqual(program.preview(time_limit=10).findings[0].kind, "TimeLimit")

    def test_recoverability_has_a_mark_for_each_stop(self):
        program = moves()
        program.add("moveRelative", z=0.01)
        marks = program.recoverability()
        self.assertEqual([mark.step for mark in marks], [1, 2, 3, 4, 5])
        self.assertEqual((marks[1].continue_from, marks[1].operator_stop), (1, "move_back"))
        self.assertIn(marks[4].protective_stop, ("continue", "move_back", "unsafe"))
        self.assertEqual(len(marks[0].reasons), 4)
        self.assertEqual({mark.not_checked for mark in marks}, {""})

    def test_steps_that_recoverability_did_not_reach_have_a_reason(self):
        program = tiller.Program("branch")
        section = program.add("if", condition="DI2")
        program.add("wait", inside=section, time=0.1)
        program.add("wait", time=0.1, disabled=True)
        program.add("wait", time=0.1)
        marks = program.recoverability()
        self.assertEqual([(mark.continue_from, mark.not_checked) for mark in marks],
                         [(4, ""), (0, "the simulated program did not reach this step, or ended in it"),
                          (0, "the step is disabled"), (4, "")])


def raising(error):
    """Returns a replacement for the context in which a handle waits. It raises the error."""

    def waiting():
        raise error

    return waiting


class TestRun(unittest.TestCase):
    def setUp(self):
        self.simulator = tiller.Simulator(virtual=True, start=START).start()
        self.addCleanup(self.simulator.stop)
        self.robot = self.simulator.robot(timeout=TIMEOUT)
        self.addCleanup(self.robot.close)
        self.robot.take_control(TIMEOUT)

    def until(self, condition):
        for _ in range(10_000):
            if condition():
                return
            self.simulator.step(0.01)
        self.fail("the condition was never true")

    def assert_brakes(self):
        """The arm stops within 250 ms and does not move again."""
        self.simulator.step(0.25)
        q = self.simulator.truth.q
        self.assertLess(float(np.abs(self.simulator.truth.qd).max()), 1e-3)
        self.simulator.step(1.0)
        self.assertLess(float(np.abs(self.simulator.truth.q - q).max()), 1e-3)

    def started(self, program=None, **options):
        """A program whose arm moves."""
        run = (program or moves(100)).start(self.robot, **options)
        self.until(lambda: float(np.abs(self.simulator.truth.qd).max()) > 0.3)
        return run

    def test_run_waits_for_the_end(self):
        program = moves()
        program.add("moveJ", waypoint="turned")
        program.run(self.robot, TIMEOUT)
        np.testing.assert_allclose(self.simulator.truth.q, TURNED, atol=2e-3)
        self.assertTrue(self.robot.in_control)
        self.robot.move_j(START).wait(TIMEOUT)  # control was taken again

    def test_a_program_shorter_than_a_data_period_completes(self):
        self.robot.close()
        robot = self.simulator.robot(timeout=TIMEOUT, frequency=10)
        self.addCleanup(robot.close)
        robot.take_control(TIMEOUT)
        program = tiller.Program("short")
        program.add("wait", time=0.02)
        for _ in range(3):
            program.run(robot, TIMEOUT)  # raises LinkLost if the end is unknown

    def test_the_handle_shows_the_step_and_pauses_between_steps(self):
        program = moves()
        run = program.start(self.robot, breakpoints=[program.steps[2]])
        self.until(lambda: run.state == "waiting")
        self.assertEqual((run.step, run.step_name, run.paused, run.active), (3, "Wait", True, True))
        self.assertIn("waiting, step 3 (Wait)", repr(run))
        np.testing.assert_allclose(self.simulator.truth.q, TURNED, atol=2e-3)
        run.step_once()
        self.until(lambda: run.state == "waiting" and run.step == 4)
        run.resume()
        self.until(lambda: run.state == "waiting" and run.step == 3)
        run.resume()
        run.wait(TIMEOUT)
        self.assertEqual((run.state, run.active, run.step, run.failed_step), ("completed", False, 0, 0))
        # The loop itself is shorter than the period of the packets.
        self.assertEqual([step.count for step in run.timings[1:]], [2, 2, 2])
        self.assertAlmostEqual(run.timings[2].total, 0.4, delta=0.05)

    def counting(self):
        """Moves only if the variable "count" is changed to 7. Pauses before step 5, after the variables are set."""
        program = moves(1)
        program.remove(program.steps[0])
        for variable, kind, value in (("count", "whole", "2"), ("depth", "number", "0.1"), ("done", "flag", "False"),
                                      ("label", "text", '"a"')):
            program.add("assign", variable=variable, type=kind, value=value)
        program.add("assign", variable="place", type="pose", value="p[0.1, 0, 0, 0, 0, 0]")
        section = program.add("if", condition="count == 7")
        program.add("moveJ", inside=section, waypoint="turned")
        run = program.start(self.robot, breakpoints=[section])
        self.until(lambda: run.state == "waiting" and run.variables.get("place") is not None)
        return run

    def test_variables_are_read_and_changed_while_the_program_waits(self):
        run = self.counting()
        values = run.variables
        self.assertIsInstance(values["place"], tiller.Pose)
        np.testing.assert_allclose(values.pop("place"), [0.1, 0, 0, 0, 0, 0])
        self.assertEqual(values, {"count": 2, "depth": 0.1, "done": False, "label": "a"})
        self.assertEqual({name: type(value) for name, value in values.items()},
                         {"count": int, "depth": float, "done": bool, "label": str})
        for name, value, text in (("count", 2.5, "not a whole number"), ("done", 1, "not True or False"),
                                  ("label", 1, "Only numbers"), ("none", 1, "no variable"),
                                  ("depth", float("nan"), "not a number")):
            with self.subTest(name), self.assertRaises(errors.InvalidArgument) as raised:
                run.set_variable(name, value)
            self.assertIn(text, str(raised.exception))
        for name, value in (("count", np.int64(7)), ("depth", -2.5e-7), ("done", True), ("done", np.bool_(False))):
            run.set_variable(name, value, TIMEOUT)
            self.assertEqual(run.variables[name], value)
        self.assertEqual(run.state, "waiting")
        np.testing.assert_allclose(self.simulator.truth.q, START, atol=1e-4)
        run.resume()
        run.wait(TIMEOUT)
        np.testing.assert_allclose(self.simulator.truth.q, TURNED, atol=2e-3)
        self.assertEqual(run.variables["count"], 7)
        with self.assertRaisesRegex(errors.InvalidArgument, "No program is running"):
            run.set_variable("count", 8)

    def test_an_exception_while_a_variable_is_set_ends_the_program(self):
        for error in (InterruptedError, KeyboardInterrupt, TimeoutError):
            with self.subTest(error.__name__):
                run = self.counting()
                with self.assertRaises(error):
                    tiller.ProgramRun(run._native, (), raising(error)).set_variable("count", 7)
                self.assert_brakes()
                with self.assertRaises(errors.Stopped):
                    run.wait(TIMEOUT)
                np.testing.assert_allclose(self.simulator.truth.q, START, atol=1e-4)

    def test_a_change_without_a_confirmation_is_a_timeout(self):
        run = self.counting()
        with self.assertRaisesRegex(errors.Timeout, "did not confirm"):
            run.set_variable("count", 7, 0.0)
        self.assertEqual(run.state, "waiting")
        run.stop()
        with self.assertRaises(errors.Stopped):
            run.wait(TIMEOUT)

    def test_pause_takes_effect_before_the_next_step(self):
        run = self.started()
        run.pause()
        self.until(lambda: run.state == "waiting")
        q = self.simulator.truth.q
        self.simulator.step(1.0)
        np.testing.assert_allclose(self.simulator.truth.q, q, atol=1e-4)
        run.stop()
        with self.assertRaises(errors.Stopped):
            run.wait(TIMEOUT)

    def test_finish_cycle_ends_an_endless_program(self):
        run = self.started(moves(0))
        run.finish_cycle()
        run.wait(TIMEOUT)
        self.assertEqual(run.state, "completed")
        np.testing.assert_allclose(self.simulator.truth.q, START, atol=2e-3)

    def test_every_call_that_stops_brakes_the_arm(self):
        for name, stop in (("ProgramRun.stop", lambda run: run.stop()), ("Robot.stop", lambda run: self.robot.stop())):
            with self.subTest(name):
                run = self.started()
                stop(run)
                self.assert_brakes()
                with self.assertRaises(errors.Stopped):
                    run.wait(TIMEOUT)
                self.assertEqual(run.state, "stopped")
                self.robot.move_j(START).wait(TIMEOUT)

    def test_a_stop_during_the_simulation_prevents_the_start(self):
        receiver_of = self.robot._receiver_of

        def stopped(*arguments):
            receiver = receiver_of(*arguments)
            self.robot.stop()
            return receiver

        self.robot._receiver_of = stopped
        run = moves(100).start(self.robot)
        with self.assertRaises(errors.Stopped):
            run.wait(TIMEOUT)
        self.assertEqual(run.state, "stopped")
        np.testing.assert_allclose(self.simulator.truth.q, START, atol=1e-4)

    def test_an_arm_that_moves_during_the_simulation_does_not_run(self):
        self.robot.move_j(TURNED)
        self.until(lambda: float(np.abs(self.simulator.truth.qd).max()) > 0.3)
        run = moves(100).start(self.robot)
        with self.assertRaisesRegex(errors.Stopped, "Move the arm to the start position first."):
            run.wait(TIMEOUT)
        self.assertEqual(run.state, "stopped")
        self.assert_brakes()

    def test_release_and_close_stop_the_program(self):
        run = self.started()
        self.robot.release()
        self.assert_brakes()
        self.assertFalse(run.active)
        self.assertFalse(self.robot.in_control)
        self.robot.take_control(TIMEOUT)
        self.robot.move_j(START).wait(TIMEOUT)
        run = self.started()
        self.robot.close()
        self.assert_brakes()
        self.assertFalse(run.active)

    def test_a_program_continues_without_its_handle(self):
        self.started()
        q = self.simulator.truth.q
        self.simulator.step(0.3)
        self.assertGreater(float(np.abs(self.simulator.truth.q - q).max()), 0.01)
        with self.assertRaisesRegex(errors.InvalidArgument, "is running. Stop it first"):
            moves().start(self.robot)
        self.robot.stop()
        self.assert_brakes()

    def test_an_exception_while_waiting_stops_the_arm(self):
        run = self.started()
        with self.assertRaises(errors.Timeout):
            run.wait(0.0)
        self.assertTrue(run.active)  # a timeout of wait() does not end the program

        # A TimeoutError of other code, e.g. of a signal handler, is not the timeout of wait().
        for error in (InterruptedError, TimeoutError):
            with self.subTest(error.__name__):
                interrupted = tiller.ProgramRun(run._native, (), raising(error))
                with self.assertRaises(error):
                    interrupted.wait()
                self.assert_brakes()
                run = self.started()
        run.stop()

    def test_an_exception_while_waiting_stops_a_motion(self):
        for error in (InterruptedError, TimeoutError):
            with self.subTest(error.__name__):
                move = self.robot.move_j(TURNED)
                self.until(lambda: float(np.abs(self.simulator.truth.qd).max()) > 0.3)
                with self.assertRaises(error):
                    tiller.Move(move._native, raising(error)).wait()
                self.assert_brakes()
                self.assertFalse(move.active)
                self.robot.move_j(START).wait(TIMEOUT)

    def test_the_timeout_of_run_stops_the_arm(self):
        with self.assertRaises(errors.Timeout):
            moves(1000).run(self.robot, 0.2)
        self.assert_brakes()

    def test_a_failed_step_is_named(self):
        program = moves()
        program.add("fail", text="No part")
        run = program.start(self.robot)
        with self.assertRaisesRegex(errors.ScriptError, "Step 5"):
            run.wait(TIMEOUT)
        self.assertEqual((run.state, run.failed_step), ("failed", 5))

    def test_a_protective_stop_ends_the_program(self):
        run = self.started()
        self.simulator.fault("protective-stop")
        self.assert_brakes()
        with self.assertRaises(tiller.Error):
            run.wait(TIMEOUT)
        self.assertEqual(run.state, "stopped")

    def test_programs_that_do_not_fit_the_robot_are_refused(self):
        other = tiller.Program("other", model="UR10e")
        other.add("wait", time=1)
        folded = tiller.Program("folded")
        folded.add_waypoint("folded", [-1.6, -1.7, -2.9, -0.8, 1.6, 0.0])
        folded.add("moveJ", waypoint="folded")
        tcp = tiller.Program("tcp")
        tcp.add_waypoint("long", START, tcp=[0, 0, 0.3, 0, 0, 0])
        tcp.add("moveL", waypoint="long")
        empty = tiller.Program("empty")
        for program, text in ((other, "different model"), (folded, "too close to itself"), (tcp, "TCP of the robot differs"),
                              (empty, "no steps")):
            with self.subTest(text), self.assertRaises(errors.InvalidArgument) as raised:
                program.start(self.robot)
            self.assertIn(text, str(raised.exception))
        self.robot.release()
        with self.assertRaises(errors.NotInControl):
            moves().start(self.robot)
        self.simulator.step(0.5)
        np.testing.assert_allclose(self.simulator.truth.q, START, atol=1e-4)

    def test_a_program_starts_at_a_step(self):
        program = moves()
        last = program.add("moveJ", waypoint="turned")
        run = program.start(self.robot, from_step=last)
        run.wait(TIMEOUT)
        self.assertEqual([step.count for step in run.timings], [0, 0, 0, 0, 1])


if __name__ == "__main__":
    unittest.main()
