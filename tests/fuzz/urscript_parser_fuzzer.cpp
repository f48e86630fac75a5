// SPDX-License-Identifier: MIT
// Any text: compiled, and when that succeeds run for some frames on a robot made of memory. Nothing may
// crash, hang or grow without bound. The stream splitter sees the same bytes in two pieces, the reader of
// XML-RPC replies takes them for one.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/simulator/urscript/interpreter.h"
#include "robot/simulator/urscript/source_splitter.h"
#include "robot/simulator/urscript/xml_rpc.h"
#include "tests/unit/robot/simulator/urscript/fake_host.h"

using namespace tiller::simulator::urscript;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);

    SourceSplitter splitter;
    splitter.feed(text.substr(0, size / 2));
    splitter.feed(text.substr(size / 2));
    while (splitter.next()) {
    }

    (void)xml_rpc::reply(text, size % 2 == 0);

    const CompileOutcome outcome = compile(text);
    if (!outcome) {
        return 0;
    }
    FakeHost host;
    host.moveFrames = 2;
    host.popupAnswered = true;
    Limits limits;
    limits.threadOperationsPerFrame = 5000;
    limits.frameOperations = 20000;
    limits.callDepth = 50;
    limits.threads = 8;
    limits.listLength = 500;
    Interpreter interpreter(outcome.program, host, limits);
    for (int frame = 0; frame < 20 && !interpreter.ended(); ++frame) {
        interpreter.runFrame();
        interpreter.resume();
        host.messages.clear();
        host.motions.clear();
        host.calls.clear();
        host.popups.clear();
        for (auto& socket : host.sockets) {
            socket.second.out.clear();
            socket.second.in = "(1, 2) 0123456789\n";
        }
    }
    return 0;
}
