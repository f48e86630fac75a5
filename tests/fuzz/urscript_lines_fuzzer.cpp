// SPDX-License-Identifier: MIT
// Submits arbitrary lines to a program in interpreter mode, with commands and frames in between. Definitions,
// calls, clears and skips must not cause a crash, a hang or an access to freed memory.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "robot/simulator/urscript/interpreter_mode.h"
#include "tests/fuzz/urscript_bounds.h"

using namespace tiller::simulator::urscript;

namespace {

const char* const kProgram =
    "def host():\n global shared = [1, 2]\n def twice(x, by=2): return x * by end\n"
    " thread counter():\n while True:\n shared[0] = shared[0] + 1\n sync()\n end\n end\n"
    " while True:\n interpreter_mode(True, False)\n sync()\n end\nend\n";

void require(bool condition) {
    if (!condition) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const CompileOutcome program = compile(kProgram);
    FakeHost host;
    hurry(host);
    Interpreter interpreter(program.program, host, lowLimits());
    interpreter.runFrame();
    InterpreterMode& mode = interpreter.mode();

    std::string_view text(reinterpret_cast<const char*>(data), size);
    std::uint32_t acknowledged = 0;
    while (!text.empty() && !interpreter.ended()) {
        const std::size_t newline = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, newline);
        text.remove_prefix(std::min(newline + 1, text.size()));
        // A line of at most one byte is a command of this fuzzer.
        if (line == "s") {
            mode.skip();
        } else if (line == "a") {
            mode.abortMove();
        } else if (line.size() <= 1) {
            interpreter.runFrame();
            interpreter.resume();
        } else {
            const InterpreterMode::Reply reply = mode.submit(line);
            switch (reply.kind) {
                case InterpreterMode::Reply::Kind::Ack:
                    require(reply.id == ++acknowledged);
                    break;
                case InterpreterMode::Reply::Kind::Discard:
                    require(!reply.reason.empty());
                    break;
                case InterpreterMode::Reply::Kind::Wait:
                    interpreter.runFrame();
                    break;
            }
        }
        const InterpreterMode::Counts& counts = mode.counts();
        require(counts.lastExecuted <= counts.lastInterpreted && counts.lastInterpreted == acknowledged &&
                counts.lastCleared <= counts.lastInterpreted && counts.unexecuted <= acknowledged);
        forget(host);
    }
    for (int frame = 0; frame < 5; ++frame) {
        interpreter.runFrame();
        interpreter.resume();
    }
    return 0;
}
