// SPDX-License-Identifier: MIT
// Methods of remote objects: calls that take frames, as some builtins do.

#include "robot/simulator/urscript/virtual_machine.h"

namespace tiller::simulator::urscript {

// False: the thread waits, and comes here again.
bool Interpreter::Machine::callRemote(Thread& thread, std::int32_t handle, const MethodCall& call,
                                      std::span<const Value> arguments, Value& result) {
    if (program->kind() == ProgramKind::Secondary) {
        fault(kTooMuchBehind);
    }
    if (call.name == "closeXMLRPCClientConnection") {
        result = Value::none();  // every call has its own connection
        return true;
    }
    if (!thread.again) {
        const Result<std::int64_t> begun = remote_.begin(handle, call.name, arguments);
        if (!begun.ok()) {
            fault(begun.error());
        }
        thread.builtinState = *begun;
        thread.builtinSince = frame;
    } else {
        Result<std::optional<Value>> outcome = remote_.result(thread.builtinState);
        if (!outcome.ok()) {
            fault(outcome.error());
        }
        if (*outcome) {
            thread.again = false;
            result = std::move(**outcome);
            return true;
        }
    }
    thread.again = true;
    thread.state = Thread::State::Polling;
    --thread.calls.back().pc;
    return false;
}

}  // namespace tiller::simulator::urscript
