// SPDX-License-Identifier: MIT
// Compiles arbitrary text and, if successful, runs it for some frames on an in-memory robot. Nothing may
// crash, hang or grow without limit. The same bytes are passed to the stream splitter in two pieces, and to
// the reader of XML-RPC replies.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/simulator/urscript/source_splitter.h"
#include "robot/simulator/urscript/xml_rpc.h"
#include "tests/fuzz/urscript_bounds.h"

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
    hurry(host);
    Interpreter interpreter(outcome.program, host, lowLimits());
    for (int frame = 0; frame < 20 && !interpreter.ended(); ++frame) {
        interpreter.runFrame();
        interpreter.resume();
        forget(host);
        for (auto& socket : host.sockets) {
            socket.second.out.clear();
            socket.second.in = "(1, 2) 0123456789\n";
        }
    }
    return 0;
}
