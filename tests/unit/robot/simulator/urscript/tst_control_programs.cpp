// SPDX-License-Identifier: MIT
// Complete programs similar to the control scripts that clients upload: a loop over command registers, and a
// loop over a socket with servo and trajectory threads.

#include "tests/unit/robot/simulator/urscript/script_run.h"

using namespace tiller::simulator::urscript;
using State = Interpreter::State;

namespace {

const char* const kRegisterProgram = R"(
def rtde_style():
    # HEADER_BEGIN
    global offset = # register offset
0    global move_thrd = 0
    global target = p[0, 0, 0, 0, 0, 0]
    global done = 2     global ready = 1

    def input(n): return read_input_float_register (n + offset) end
    def command(): return read_input_integer_register(offset) end
    def answer(state):
        write_output_integer_register(0 + offset, state)
    end

    def scaled(p, factor):
        p[0] = p[0] * factor
        p[1] = p[1] * factor
        return p
    end
    def is_null(p):
        local sum = norm(p[0]) + norm (p[1]) + norm(p[2])
        return (sum < 0.0000000001)
    end

    thread move_thread():
        enter_critical
        movej([target[0], target[1], target[2], target[3], target[4], target[5]], a = 1.4, v = 1.05)
        exit_critical
        move_thrd = 0
    end

    def process(cmd):
        if cmd == 1:
            target = p[input(0), input(1), input(2), input(3), input(4), input(5)]
            if is_null(target):
                textmsg("ignored")
            elif move_thrd == 0:
                global move_thrd = run move_thread()
            else:
                kill move_thrd
                move_thrd = run move_thread()
            end
        elif cmd == 2:
            if move_thrd != 0:
                kill move_thrd
                move_thrd = 0
            end
            enter_critical
            stopj(input(0))
            exit_critical
        elif cmd == 3:
            p = scaled(p[input(0), input(1), 0, 0, 0, 0], 2)
            write_output_float_register(0, p[0])
            write_output_float_register(1, p[1])
        else:
            return cmd != 255
        end
        return cmd != 255
    end
    # NODE_CONTROL_LOOP_BEGINS
    keep = True
    executing = False
    answer(ready)
    while keep:
        cmd = command()
        if cmd == 0:
            executing = False
            answer(ready)
        elif executing == False:
            keep = process(cmd)
            executing = True
            answer(done)
        end
        sync()
    end
    textmsg("bye")
end
)";

const char* const kSocketProgram = R"(
	def socket_style():
	global STEP = get_steptime()
	MULT = 1000000
	MODE_STOPPED = -2   MODE_IDLE = 0
	MODE_SERVO = 1
	MODE_FORWARD = 3
	control_mode = -1
	global servo_target = get_joint_positions()
	global points_left = 0
	thread_move = 0
	extrapolated = 0
	global result = -1

	thread servoThread():
	  state = MODE_IDLE
	  while control_mode == MODE_SERVO:
	    enter_critical
	    q = servo_target
	    exit_critical
	    servoj(q, t = STEP, lookahead_time=0.03, gain=2000)
	    extrapolated = extrapolated + 1
	  end
	  stopj(4.0)
	end

	thread trajectoryThread():
	  enter_critical
	  while points_left > 0:
	    raw = socket_read_binary_integer(4, "trajectory", 0.5)
	    if raw[0] > 0:
	      local q = [raw[1], raw[2], raw[3], 0, 0, 0] / MULT
	      local tt = raw[4] / MULT
	      points_left = points_left - 1
	      if tt > 0.0:
	        movej(q, t = tt, r = 0)
	      else:
	        movej(q, a = 1.4,
	              v = 1.05)
	      end
	    else:
	      textmsg("no point")
	      result = 2
	      points_left = 0
	    end
	  end
	  exit_critical
	  stopj(4.0)
	  if result < 0: result = 0 end
	  socket_send_int(result, "trajectory")
	end

	def end_motion():
	  if thread_move != 0:
	    kill thread_move
	    thread_move = 0
	    stopj(4.0)
	  end
	end

	ok = socket_open("127.0.0.1", 50003, "trajectory") and socket_open("127.0.0.1", 50001, "reverse")
	if not ok:
	  popup(str_cat("Connection <b>failed</b> # ", to_str(50001)), title="Tiller", error = True, blocking = True)
	  halt
	end
	timeout = 0
	while control_mode > MODE_STOPPED:
	  enter_critical
	  raw = socket_read_binary_integer(8, "reverse", timeout)
	  if raw[0] > 0:
	    timeout = raw[1] / 1000.0
	    if control_mode != raw[8]:
	      end_motion()
	      control_mode = raw[8]
	      if control_mode == MODE_SERVO:
	        thread_move = run servoThread()
	      end
	    end
	    if control_mode == MODE_SERVO:
	      servo_target = [raw[2], raw[3], raw[4], raw[5], raw[6], raw[7]] / MULT
	    elif control_mode == MODE_FORWARD:
	      if raw[2] == 1:
	        points_left = raw[3]
	        result = -1
	        thread_move = run trajectoryThread()
	      elif raw[2] == -1:
	        end_motion()
	        points_left = 0
	        result = 1
	        socket_send_int(result, "trajectory")
	      end
	    end
	  else:
	    textmsg("timed out after ", timeout)
	    control_mode = MODE_STOPPED
	  end
	  exit_critical
	end
	end_motion()
	socket_close("trajectory")
	socket_close("reverse")
	end
)";

std::string packed(std::initializer_list<int> values) {
    std::string out;
    for (const int v : values) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            out += static_cast<char>(static_cast<unsigned>(v) >> shift & 0xff);
        }
    }
    return out;
}

template <class Command>
std::size_t countOf(const FakeHost& host) {
    std::size_t n = 0;
    for (const auto& motion : host.motions) {
        n += std::holds_alternative<Command>(motion.command) ? 1u : 0u;
    }
    return n;
}

}  // namespace

class tst_ControlPrograms : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void registerProgramExecutesEachCommandOnce() {
        ScriptRun run(kRegisterProgram);
        run.frames(3);
        QCOMPARE(run.host.intOut[0], 1);
        run.host.floatIn = {1.5, -2.25};
        run.host.intIn[0] = 3;
        run.frames(1);
        QCOMPARE(run.host.intOut[0], 2);
        QCOMPARE(run.host.floatOut[0], 3.0);
        QCOMPARE(run.host.floatOut[1], -4.5);
        run.host.intIn[0] = 0;
        run.frames(1);
        QCOMPARE(run.host.intOut[0], 1);
        QCOMPARE(run.interpreter->state(), State::Running);
    }
    void registerProgramMovesAsynchronouslyAndStops() {
        ScriptRun run(kRegisterProgram);
        run.host.moveFrames = 50;
        run.host.floatIn = {0.5, -1, 1, 0, 0, 0};
        run.host.intIn[0] = 1;
        run.frames(2);
        QCOMPARE(run.host.intOut[0], 2);
        QCOMPARE(countOf<Move>(run.host), 1u);
        QCOMPARE(std::get<tiller::JointPositions>(std::get<Move>(run.host.motions[0].command).target)[1],
                 -1.0);
        run.host.intIn[0] = 0;
        run.frames(5);
        run.host.intIn[0] = 1;  // a new target during motion: the old thread is killed, the new one starts
        run.frames(2);
        QCOMPARE(countOf<Move>(run.host), 2u);
        QCOMPARE(run.host.abandoned.size(), 1u);
        run.host.intIn[0] = 0;
        run.frames(2);
        run.host.moveFrames = 3;
        run.host.intIn[0] = 2;
        run.frames(1);
        QCOMPARE(countOf<StopJ>(run.host), 1u);
        run.frames(4);
        QCOMPARE(run.host.intOut[0], 2);
        QCOMPARE(run.value("move_thrd"), "0");
        run.host.intIn[0] = 0;
        run.frames(1);
        run.host.intIn[0] = 255;
        QCOMPARE(run.frames(2), State::Finished);
        QCOMPARE(run.host.lastMessage(), "bye");
        QCOMPARE(run.host.ended, 1);
    }
    void socketProgramServosEveryFrameWhileItReads() {
        ScriptRun run(kSocketProgram);
        QCOMPARE(run.frames(10), State::Running);
        run.host.sockets["reverse"].in = packed({100, 1000000, 2000000, 3000000, 0, 0, 500000, 1});
        run.frames(30);
        QCOMPARE(countOf<ServoJ>(run.host), 30u);
        QCOMPARE(std::get<ServoJ>(run.host.motions.back().command).q[5], 0.5);
        run.host.sockets["reverse"].in = packed({100, 1, 1, 1, 1, 1, 1, -2});
        QCOMPARE(run.frames(20), State::Finished);
        QCOMPARE(countOf<StopJ>(run.host), 1u);
        QVERIFY(run.host.sockets["reverse"].state == SocketHost::State::Closed);
    }
    void socketProgramStopsWhenTheClientIsSilent() {
        ScriptRun run(kSocketProgram);
        run.host.sockets["reverse"].in = packed({20, 0, 0, 0, 0, 0, 0, 1});
        run.frames(5);
        QCOMPARE(run.interpreter->state(), State::Running);
        QCOMPARE(run.frames(40), State::Finished);
        QCOMPARE(run.host.lastMessage(), "timed out after 0.02");
    }
    void socketProgramRunsTrajectories() {
        ScriptRun run(kSocketProgram);
        run.host.moveFrames = 10;
        run.host.sockets["trajectory"].in =
            packed({100000, 200000, 300000, 100000}) + packed({0, 0, 0, 0}) + packed({400000, 0, 0, 20000});
        run.host.sockets["reverse"].in = packed({0, 1, 3, 0, 0, 0, 0, 3});
        run.frames(200);
        QCOMPARE(run.host.sockets["trajectory"].out, packed({0}));
        QCOMPARE(countOf<Move>(run.host), 3u);
        QCOMPARE(std::get<Move>(run.host.motions[0].command).duration, 0.1);
    }
    void socketProgramCancelsInsideTheCriticalSection() {
        ScriptRun run(kSocketProgram);
        run.host.moveFrames = 1000;
        run.host.sockets["trajectory"].in = packed({100000, 200000, 300000, 0}) + packed({0, 0, 0, 0});
        run.host.sockets["reverse"].in = packed({0, 1, 2, 0, 0, 0, 0, 3});
        run.frames(10);
        QCOMPARE(countOf<Move>(run.host), 1u);
        run.host.moveFrames = 5;
        run.host.sockets["reverse"].in = packed({0, -1, 0, 0, 0, 0, 0, 3});
        run.frames(10);
        QCOMPARE(run.host.sockets["trajectory"].out, packed({1}));
        QCOMPARE(countOf<StopJ>(run.host), 1u);
        QCOMPARE(run.interpreter->state(), State::Running);
    }
    void socketProgramFailsWithoutPoints() {
        ScriptRun run(kSocketProgram);
        run.host.sockets["reverse"].in = packed({0, 1, 2, 0, 0, 0, 0, 3});
        run.frames(251);
        QCOMPARE(run.host.sockets["trajectory"].out, "");
        run.frames(20);
        QCOMPARE(run.host.sockets["trajectory"].out, packed({2}));
    }
};

QTEST_GUILESS_MAIN(tst_ControlPrograms)
#include "tst_control_programs.moc"
