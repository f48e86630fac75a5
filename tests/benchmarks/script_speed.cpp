// SPDX-License-Identifier: MIT
// Measures the speed of the URScript interpreter: simple statements per second in one or more threads, and
// the cost of a control loop at 500 Hz. Only the interpreter is measured, with a host that responds
// immediately.
//
//     script_speed [seconds for each row, 1 by default]
//
// Rates are based on processor time, and percentiles on wall time. Target: 10 million simple statements per
// second and thread, and a control loop below 5 % of one core.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "robot/simulator/urscript/interpreter.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

using namespace tiller::simulator::urscript;

namespace {

using Clock = std::chrono::steady_clock;

/// Processor time of this program only, so that other processes have no effect.
double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// `body` consists of `statements` simple statements, which each thread repeats.
struct Load {
    const char* name;
    int statements;
    const char* body;
};

constexpr Load kLoads[] = {
    {"assign a constant", 10, "a = 1 b = 2 c = 3 a = 4 b = 5 c = 6 a = 7 b = 8 c = 9 a = 0"},
    {"assign a variable", 10, "a = b b = c c = a a = b b = c c = a a = b b = c c = a a = b"},
    {"integer sum", 10,
     "a = a + 1 b = b + 1 c = c + 1 a = a - 1 b = b - 1 c = c - 1 a = a + b b = b + c c = c - a a = 0"},
    {"float product", 10,
     "x = y * 0.5 y = x * 2.0 x = y * 0.5 y = x * 2.0 x = y * 0.5 y = x * 2.0 x = y * 0.5 "
     "y = x * 2.0 x = 1.5 y = 2.5"},
    {"condition", 5,
     "if a < 1: a = 1 end if b == 2: b = 3 end if c > 4: c = 0 end if a != 1: a = 1 end if b >= 9: b = 1 "
     "end"},
    {"list element", 6, "l[0] = 1.5 x = l[1] l[2] = x y = l[3] l[4] = y x = l[5]"},
    {"call of a function", 4, "x = f(1.0) y = f(2.0) x = f(3.0) y = f(4.0)"},
    {"call of a builtin", 4, "x = sin(0.5) y = cos(0.5) x = sqrt(2.0) y = norm(3.0)"},
};

/// Returns the total number of statements per second in all threads. The number of iterations is read from
/// the program.
double statementRate(const Load& load, int threads, double seconds) {
    std::string text =
        "def m():\nglobal rounds = [0,0,0,0,0,0,0,0]\ndef f(v):\nreturn v\nend\nthread t():\nlocal me = "
        "next\n"
        "local a = 0\nlocal b = 0\nlocal c = 0\nlocal x = 1.5\nlocal y = 2.5\nlocal l = "
        "[0.0,1.0,2.0,3.0,4.0,5.0]\n"
        "while True:\nlocal i = 0\nwhile i < 100:\n" +
        std::string(load.body) +
        "\ni = i + 1\nend\nrounds[me] = rounds[me] + 1\nsync()\nend\nend\nnext = 0\n";
    for (int i = 0; i < threads; ++i) {
        text += "h = run t()\nsync()\nnext = next + 1\n";
    }
    text += "while True:\nsync()\nend\nend\n";
    const CompileOutcome outcome = compile(text);
    if (!outcome) {
        std::fprintf(stderr, "%d:%d %s\n", outcome.error.line, outcome.error.column,
                     outcome.error.text.c_str());
        std::exit(1);
    }
    FakeHost host;
    Interpreter interpreter(outcome.program, host);
    for (int i = 0; i < 2 * threads + 10; ++i) {
        interpreter.runFrame();
    }
    const auto rounds = [&] {
        double sum = 0;
        for (const double d : interpreter.global("rounds")->list().numbers) {
            sum += d;
        }
        return sum;
    };
    const double before = rounds();
    const double start = processorSeconds();
    double elapsed = 0;
    while ((elapsed = processorSeconds() - start) < seconds) {
        for (int i = 0; i < 100; ++i) {
            interpreter.runFrame();
        }
    }
    if (interpreter.ended()) {
        std::fprintf(stderr, "%s\n", interpreter.error() ? interpreter.error()->text.c_str() : "ended");
        std::exit(1);
    }
    // The two statements of the loop itself (condition and count) are not included.
    return (rounds() - before) * 100 * load.statements / elapsed;
}

// A typical remote control program with a main loop that reads registers and executes commands, a servo
// thread, a watchdog, status output, and a trajectory spline that is evaluated in every frame.
const char* const kControlLoop = R"(
def control():
  global target = [0.1,-1.2,1.3,-1.4,-1.5,0.6]
  global command = 0
  steptime = get_steptime()
  thread servo():
    while True:
      enter_critical
      servoj(target, t=steptime, lookahead_time=0.03, gain=2000)
      exit_critical
    end
  end
  def vector(first):
    return [read_input_float_register(first), read_input_float_register(first + 1), read_input_float_register(first + 2), read_input_float_register(first + 3), read_input_float_register(first + 4), read_input_float_register(first + 5)]
  end
  def spline(t):
    local c1 = [0.1,0.2,0.3,0.1,0.2,0.3]
    local c2 = [0.2,0.1,0.3,0.2,0.1,0.3]
    local c3 = [0.3,0.2,0.1,0.3,0.2,0.1]
    local c4 = [0.1,0.3,0.2,0.1,0.3,0.2]
    local c5 = [0.2,0.3,0.1,0.2,0.3,0.1]
    return c1 + 2.0*t*c2 + 3.0*pow(t,2)*c3 + 4.0*pow(t,3)*c4 + 5.0*pow(t,4)*c5
  end
  global mover = run servo()
  count = 0
  while True:
    command = read_input_integer_register(0)
    if command == 1:
      textmsg("one")
    elif command == 2:
      textmsg("two")
    elif command == 9 or command == 10:
      stopj(2)
    elif command == 0:
      target = vector(0)
      qd = spline(count * steptime % 5.0)
      if norm(qd) > 100.0:
        textmsg("too fast")
      end
    end
    count = count + 1
    write_output_integer_register(0, command)
    write_output_integer_register(1, count)
    write_output_float_register(0, norm(target - get_actual_joint_positions()))
    write_output_float_register(1, qd[0])
    sync()
  end
end
)";

struct Percentiles {
    double median, p99, p999, mean;
};

/// Returns the cost per frame of the control loop [us].
Percentiles controlLoopCost(double seconds) {
    const CompileOutcome outcome = compile(kControlLoop);
    if (!outcome) {
        std::fprintf(stderr, "%d:%d %s\n", outcome.error.line, outcome.error.column,
                     outcome.error.text.c_str());
        std::exit(1);
    }
    FakeHost host;
    Interpreter interpreter(outcome.program, host);
    std::vector<double> costs;
    const double begin = processorSeconds();
    double spent = 0;
    while ((spent = processorSeconds() - begin) < seconds) {
        const Clock::time_point start = Clock::now();
        interpreter.runFrame();
        costs.push_back(1e6 * secondsSince(start));
        host.motions.clear();
    }
    if (interpreter.ended()) {
        std::fprintf(stderr, "%s\n", interpreter.error() ? interpreter.error()->text.c_str() : "ended");
        std::exit(1);
    }
    std::sort(costs.begin(), costs.end());
    const auto at = [&](double share) {
        return costs[static_cast<std::size_t>(share * double(costs.size() - 1))];
    };
    // The mean is an upper bound, because it is based on processor time including the measurement itself.
    return {at(0.5), at(0.99), at(0.999), 1e6 * spent / double(costs.size())};
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::max(std::atof(argv[1]), 0.01) : 1.0;
    std::printf("Simple statements, million a second (wanted: 10 in a thread)\n");
    std::printf("%-22s %12s %12s\n", "", "one thread", "8 threads");
    for (const Load& load : kLoads) {
        std::printf("%-22s %12.1f %12.1f\n", load.name, statementRate(load, 1, seconds) / 1e6,
                    statementRate(load, 8, seconds) / 1e6);
        std::fflush(stdout);
    }
    const Percentiles cost = controlLoopCost(3 * seconds);
    std::printf("\nControl loop script at 500 Hz, interpreter alone\n");
    std::printf("%-22s %12s %12s %12s\n", "us a frame", "median", "p99", "p99.9");
    std::printf("%-22s %12.1f %12.1f %12.1f\n", "", cost.median, cost.p99, cost.p999);
    std::printf("%-22s %11.2f%% (wanted: below 5%%)\n", "of one core", 100 * cost.mean / 2000);
    return 0;
}
